#include "kiosk/collection/content/vessel.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "engine/profile/measures.h"
#include "engine/profile/slices.h"
#include "kiosk/collection/content/gltf_parts.h"
#include "kiosk/collection/content/lighter_mesh.h"
#include "kiosk/collection/content/mesh_file.h"
#include "kiosk/collection/content/pack.h"
#include "kiosk/collection/content/scan_document.h"
#include "kiosk/collection/content/screen_model.h"
#include "kiosk/collection/content/true_size.h"
#include "kiosk/collection/content/vessel_file.h"
#include "kiosk/collection/decoration/decoration.h"
#include "kiosk/collection/settings/visitor_text.h"

namespace onggi::content {

namespace {

namespace fs = std::filesystem;

/// The file's mesh, turned so that its axis is y and its foot is at 0, times `scale`.
TriangleMesh upright(const TriangleMesh& mesh, const ExtractedProfile& found, double scale) {
  const extraction::AxisFrame f = extraction::axis_frame(found.axis_origin, found.axis_direction);
  TriangleMesh out;
  out.triangles = mesh.triangles;
  out.positions.reserve(mesh.positions.size());
  out.normals.reserve(mesh.normals.size());
  const auto turned = [&](Vec3 v) {
    return std::array<float, 3>{static_cast<float>(dot(v, f.across)),
                                static_cast<float>(dot(v, f.up)),
                                static_cast<float>(dot(v, f.along))};
  };
  for (const auto& p : mesh.positions)
    out.positions.push_back(turned((Vec3{p[0], p[1], p[2]} - f.origin) * scale));
  for (const auto& n : mesh.normals) out.normals.push_back(turned({n[0], n[1], n[2]}));
  return out;
}

/// "moon_jar" -> "Moon jar".
std::string title_of(const std::string& id) {
  std::string out = id;
  std::replace(out.begin(), out.end(), '_', ' ');
  if (!out.empty() && out[0] >= 'a' && out[0] <= 'z')
    out[0] = static_cast<char>(out[0] - 'a' + 'A');
  return out;
}

/// What is known before the file is read: `vessel` has the pack's values.
struct Order {
  Vessel vessel;
  ToldSize told;
  std::optional<std::array<float, 3>> color;  ///< From the pack.
  fs::path decoration;                        ///< Its own colours are from this file; or empty.
  GltfCredit document;                        ///< Credit from a document that names the file.
  LoadOptions options;
};

/// The vessel in `mesh`, without its size.
Result<Vessel> measured(const Order& order, const GltfModel& model, const NamedPart& named,
                        const TriangleMesh& mesh, const std::string& name) {
  Vessel vessel = order.vessel;
  ExtractionOptions options;
  options.up = order.options.up;
  auto found = extract_profile(mesh, options, name);
  if (!found) return tl::unexpected<Problem>(found.error());
  vessel.extracted = std::move(*found);
  vessel.extracted.warnings.insert(vessel.extracted.warnings.end(), model.warnings.begin(),
                                   model.warnings.end());
  vessel.given = model.credit.after(order.document);
  // A scan's own words are cut here; nobody can be asked to correct them.
  using settings::fitted;
  namespace bounds = settings::bounds;
  if (vessel.credit.empty()) vessel.credit = fitted(vessel.given.line(), bounds::kLabelCredit);
  if (vessel.licence.empty()) vessel.licence = fitted(vessel.given.licence, bounds::kLicence);
  if (vessel.source.empty()) vessel.source = vessel.given.source;
  // Trust only a museum's own document for the museum's page; a scan may name any page.
  if (vessel.address.empty()) vessel.address = order.document.address;
  if (model.colored) vessel.color = model.base_color;
  vessel.coloring =
      named.part == nullptr ? model.coloring : coloring_of(model, *named.part, named.reach);
  if (order.color) {
    vessel.color = *order.color;
    if (order.decoration.empty()) vessel.coloring = {};
  }
  return vessel;
}

FileSize size_of(const Vessel& measured) {
  const Profile& p = measured.extracted.profile;
  return {p.height(), 2.0 * p.max_radius()};
}

/// Turns and scales a measured vessel.
void set_upright(Vessel& vessel, const TriangleMesh& mesh, const TrueSize& size, bool for_screen) {
  ExtractedProfile& found = vessel.extracted;
  vessel.unit = size.unit;
  vessel.size_from = size.from;
  if (!size.doubt.empty()) found.warnings.push_back(size.doubt);
  vessel.mesh = upright(mesh, found, vessel.unit);
  if (for_screen) fit_to_screen(vessel.mesh, vessel.coloring);
  vessel.turning = lighter(vessel.mesh);
  found.profile = scaled(found.profile, vessel.unit);
  found.inferred_wall *= vessel.unit;
  if (size.from == SizeFrom::diameter) vessel.true_height = found.profile.height();
  if (found.inferred_wall > 0.0)
    found.warnings.push_back("Where the inner wall was not visible, it is drawn " +
                             three_digits(1000.0 * found.inferred_wall) +
                             " mm inside the outer one.");
}

/// Where the makers began. What is wrong with the file is told by catalogue.h.
std::vector<decoration::Start> starts_of(const Order& order, const Profile& outline) {
  if (order.decoration.empty()) return {};
  const auto decoration = decoration::read_decoration(order.decoration);
  double outside = 0.0;
  for (std::size_t n = 1; n < outline.points.size(); ++n)
    outside += std::hypot(outline.points[n].outer - outline.points[n - 1].outer,
                          outline.points[n].height - outline.points[n - 1].height);
  if (!decoration || !(outside > 0.0)) return {};
  return decoration::starts_of(*decoration, outside);
}

std::string called(const GltfPart& part) {
  return part.name.empty() ? std::to_string(part.node) : part.name;
}

void name_nodes(Vessel& vessel, const GltfModel& model, const NamedPart& whole) {
  for (const GltfPart& part : model.parts) {
    if (!part.mesh) continue;
    const bool within = whole.part == nullptr ||
                        (part.first_triangle >= whole.part->first_triangle &&
                         part.first_triangle < whole.part->first_triangle + whole.part->triangles);
    const bool other = whole.part != nullptr && whole.part->mesh && whole.reach == Reach::alone &&
                       &part != whole.part;
    if (within && !other) vessel.nodes.push_back({called(part), part.own_triangles});
  }
}

/// "a", "b" ... for the parts with a surface, at most twelve.
std::string names_of(const std::vector<const GltfPart*>& parts) {
  constexpr std::size_t kMost = 12;
  std::string names;
  for (std::size_t i = 0; i < std::min(parts.size(), kMost); ++i)
    names += (i == 0 ? "\"" : ", \"") + called(*parts[i]) + "\"";
  return names + (parts.size() > kMost ? " ..." : "");
}

/// `problem` of a whole file, with the names of its objects if it has several.
Problem with_nodes(Problem problem, const GltfModel& model) {
  std::vector<const GltfPart*> parts;
  for (const GltfPart& part : model.parts)
    if (part.mesh) parts.push_back(&part);
  if (parts.size() > 1)
    problem.remedy += " The file holds " + std::to_string(parts.size()) +
                      " objects: " + names_of(parts) +
                      "; --node NAME, or node in vessel.toml, reads one alone.";
  return problem;
}

Result<Vessel> load_one(const Order& order, const GltfModel& model, const NamedPart& named) {
  const bool whole = named.part == nullptr;
  const TriangleMesh own = whole ? TriangleMesh{} : mesh_of(model, *named.part, named.reach);
  const TriangleMesh& mesh = whole ? model.mesh : own;
  std::string name = order.vessel.file.string();
  if (!whole) name += ", node \"" + called(*named.part) + "\"";
  auto vessel = measured(order, model, named, mesh, name);
  if (!vessel) return whole ? tl::unexpected<Problem>(with_nodes(vessel.error(), model)) : vessel;
  name_nodes(*vessel, model, named);
  const auto size = true_size(size_of(*vessel), order.told, name);
  if (!size) return tl::unexpected<Problem>(size.error());
  set_upright(*vessel, mesh, *size, order.options.for_screen);
  vessel->starts = starts_of(order, vessel->extracted.profile);
  return vessel;
}

Problem several_objects(const Order& order, const std::vector<const GltfPart*>& objects) {
  return {order.vessel.file.string(),
          "it holds " + std::to_string(objects.size()) +
              " objects that do not all touch: " + names_of(objects) + ".",
          "Name the one that is the vessel: --node NAME, or node = \"NAME\" in vessel.toml."};
}

Result<Vessel> load_named(const Order& order, const GltfModel& model) {
  const std::string& wanted = order.options.node;
  if (wanted.empty()) {
    if (const auto objects = separate_objects(model); !objects.empty())
      return tl::unexpected<Problem>(several_objects(order, objects));
    return load_one(order, model, {});
  }
  if (const NamedPart named = find_part(model, wanted); named.part != nullptr)
    return load_one(order, model, named);
  std::vector<const GltfPart*> parts;
  for (const GltfPart& part : model.parts) parts.push_back(&part);
  return problem(order.vessel.file.string(),
                 "it has no node \"" + wanted.substr(0, 80) + "\" that carries a surface.",
                 "Name one of these nodes: " + names_of(parts) + ".");
}

/// The letters, digits and _ of a node's name, for an id.
std::string plain(const std::string& name) {
  std::string out;
  for (const char c : name) {
    const bool keeps = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       static_cast<unsigned char>(c) >= 0x80;
    if (keeps)
      out += c;
    else if (!out.empty() && out.back() != '_')
      out += '_';
  }
  return out;
}

Result<std::vector<Vessel>> load_each(const Order& order, const GltfModel& model,
                                      const std::vector<const GltfPart*>& objects) {
  const auto most = static_cast<std::size_t>(order.options.limits.vessels_in_a_file);
  if (objects.size() > most)
    return tl::unexpected(beyond_limit(
        order.vessel.file.string(), "it holds " + std::to_string(objects.size()) + " objects",
        std::to_string(most), "vessels_in_a_file", "Export a few vessels to a file"));
  std::vector<Vessel> out;
  std::vector<NamedPart> parts;
  std::string others;
  for (const GltfPart* part : objects) {
    NamedPart named{part, Reach::all};
    auto vessel = measured(order, model, named, mesh_of(model, *part, named.reach), called(*part));
    if (!vessel && part->own_triangles < part->triangles) {  // without its bail, for example
      named.reach = Reach::alone;
      vessel = measured(order, model, named, mesh_of(model, *part, named.reach), called(*part));
    }
    if (!vessel) {
      others += (others.empty() ? "\"" : ", \"") + called(*part) + "\"";
      continue;
    }
    vessel->node = called(*part);
    vessel->id += "_" + plain(vessel->node);
    // A pack made from it then reads the same part.
    if (named.reach == Reach::all && part->own_triangles < part->triangles) vessel->node += "/*";
    for (const Vessel& other : out)
      if (other.id == vessel->id) vessel->id += "_" + std::to_string(part->node);
    name_nodes(*vessel, model, named);
    out.push_back(std::move(*vessel));
    parts.push_back(named);
  }
  if (out.empty()) return tl::unexpected<Problem>(several_objects(order, objects));
  if (!others.empty())
    out.front().extracted.warnings.push_back(
        "The file also holds objects that are not vessels: " + others + ".");
  // A set uses one unit, which its largest piece shows.
  FileSize largest;
  for (const Vessel& v : out) {
    const FileSize own = size_of(v);
    if (std::max(own.height, own.widest) > std::max(largest.height, largest.widest)) largest = own;
  }
  const auto size = true_size(largest, order.told, order.vessel.file.string());
  if (!size) return tl::unexpected<Problem>(size.error());
  for (std::size_t i = 0; i < out.size(); ++i)
    set_upright(out[i], mesh_of(model, *parts[i].part, parts[i].reach), *size,
                order.options.for_screen);
  return out;
}

/// What the pack in `folder` says, or what is wrong with it.
Result<Order> order_of_pack(const fs::path& folder, const LoadOptions& options) {
  const PackRead read = read_pack(folder / "vessel.toml");
  if (!read.problems.empty()) return tl::unexpected<Problem>(read.problems.front());
  const Pack& pack = read.pack;
  Order order;
  Vessel& vessel = order.vessel;
  vessel.id = options.id.empty() ? folder.filename().string() : options.id;
  vessel.file = folder / "vessel.glb";
  std::error_code ignored;
  if (!fs::exists(vessel.file, ignored) && fs::exists(folder / "vessel.gltf", ignored))
    vessel.file = folder / "vessel.gltf";
  if (!fs::exists(vessel.file, ignored))
    return problem(folder.string(), "it has no vessel.glb.",
                   pack.drawing.empty()
                       ? "Put the vessel's mesh into the folder as vessel.glb."
                       : "Make it: onggi vessel make " + (folder / pack.drawing).string() + " -o " +
                             vessel.file.string());
  vessel.labels = pack.labels;
  vessel.credit = pack.credit_line();
  vessel.way = pack.way;
  vessel.built = pack.built;
  vessel.paddle = pack.paddle;
  vessel.glazes = pack.glazes;
  vessel.licence = pack.licence;
  vessel.source = pack.source;
  vessel.address = pack.address;
  vessel.true_height = pack.true_height;
  vessel.node = pack.node;
  order.told.height = pack.true_height;
  order.told.diameter = pack.true_diameter;
  order.told.unit = pack.unit;
  order.options = options;
  if (!pack.node.empty()) order.options.node = pack.node;
  if (pack.up && !options.up) order.options.up = pack.up;
  if (pack.color) order.color = pack.color;
  if (!pack.decoration.empty()) order.decoration = folder / pack.decoration;
  return order;
}

Result<Order> order_of(const fs::path& path, const LoadOptions& options) {
  // Treat "pack/" like "pack".
  const fs::path named = path.filename().empty() ? path.parent_path() : path;
  std::error_code ignored;
  if (fs::exists(named / "vessel.toml", ignored)) return order_of_pack(named, options);
  Order order;
  order.vessel.id = options.id.empty() ? named.stem().string() : options.id;
  order.vessel.file = named;
  if (is_document_ending(named)) {
    auto document = read_scan_document(named, options.limits);
    if (!document) return tl::unexpected<Problem>(document.error());
    order.vessel.file = document->model;
    if (options.id.empty()) order.vessel.id = document->model.stem().string();
    order.told.unit = document->unit;
    order.document = std::move(document->credit);
  }
  order.vessel.node = options.node;
  order.told.format_unit = format_unit(order.vessel.file);
  order.options = options;
  return order;
}

Problem no_memory(const fs::path& path) {
  return {path.string(), "it needs more memory than there is.",
          "Export the vessel with fewer triangles."};
}

}  // namespace

Label Vessel::label(const std::string& language) const {
  for (const std::string& wanted : {language, std::string("en")})
    if (const auto found = labels.find(wanted); found != labels.end()) {
      Label label = found->second;
      if (label.address.empty()) label.address = address;
      return label;
    }
  Label made;
  made.address = address;
  const std::string name = node.substr(0, node.find("/*"));
  const auto in = given.titles.find(language);
  const std::string title = !name.empty() ? title_of(name)
                            : in != given.titles.end()
                                ? in->second
                                : title_of(!given.title.empty() ? given.title : id);
  // A file can have any name, and a document any words.
  using settings::fitted;
  namespace bounds = settings::bounds;
  made.title = fitted(settings::is_blank(title) ? title_of(id) : title, bounds::kTitle);
  made.culture = fitted(given.culture, bounds::kCulture);
  // From a document; a scan's date is the scan's own.
  if (!given.culture.empty()) made.date = fitted(given.date, bounds::kDate);
  return made;
}

Result<Vessel> load_vessel(const fs::path& path, const LoadOptions& options) {
  try {
    const auto order = order_of(path, options);
    if (!order) return tl::unexpected<Problem>(order.error());
    const auto model = read_mesh_file(order->vessel.file, options.limits);
    if (!model) return tl::unexpected<Problem>(model.error());
    return load_named(*order, *model);
  } catch (const std::bad_alloc&) {
    return tl::unexpected<Problem>(no_memory(path));
  }
}

Result<std::vector<Vessel>> load_vessels(const fs::path& path, const LoadOptions& options) {
  try {
    const auto order = order_of(path, options);
    if (!order) return tl::unexpected<Problem>(order.error());
    const auto model = read_mesh_file(order->vessel.file, options.limits);
    if (!model) return tl::unexpected<Problem>(model.error());
    // One label, size and number cannot be right for ten vessels, so a pack must name its object.
    if (order->options.node.empty() && order->vessel.labels.empty())
      if (const auto objects = separate_objects(*model); !objects.empty())
        return load_each(*order, *model, objects);
    auto vessel = load_named(*order, *model);
    if (!vessel) return tl::unexpected<Problem>(vessel.error());
    std::vector<Vessel> out;
    out.push_back(std::move(*vessel));
    return out;
  } catch (const std::bad_alloc&) {
    return tl::unexpected<Problem>(no_memory(path));
  }
}

}  // namespace onggi::content
