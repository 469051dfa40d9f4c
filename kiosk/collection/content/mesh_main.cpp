// onggi-mesh: the only program that links Assimp. It reads one OBJ, PLY or STL from standard input.
//
//   onggi-mesh ENDING VERTICES TRIANGLES MEMORY_MIB SECONDS < file > parts
//
// Assimp was not written for untrusted files, so it has its own process with limited memory and
// time, no file but its three streams, and only these three importers. mesh_parts.h describes its
// output; the kiosk checks every number in it. Exit 0, also if the file is refused; 1 with the
// reason on standard error.

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "kiosk/collection/content/mesh_parts.h"
#include "kiosk/ground/files/confined.h"

namespace {

using onggi::content::MeshPart;

/// An OBJ can name further files, and Assimp would open them. This class opens none.
class NoFiles : public Assimp::IOSystem {
 public:
  bool Exists(const char*) const override { return false; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char*, const char*) override { return nullptr; }
  void Close(Assimp::IOStream*) override {}
};

/// Importers that guess by a file's first bytes would try a hundred formats.
void leave_only(Assimp::Importer& importer, const std::string& ending) {
  std::vector<Assimp::BaseImporter*> others;
  for (std::size_t i = 0; i < importer.GetImporterCount(); ++i)
    if (importer.GetImporter(ending.c_str()) != importer.GetImporter(i))
      others.push_back(importer.GetImporter(i));
  for (Assimp::BaseImporter* other : others) importer.UnregisterLoader(other);
}

/// Assimp's message without the file name that Assimp invents.
std::string without_its_name(std::string words) {
  const auto name = words.find("$$$___magic___$$$");
  if (name == std::string::npos) return words;
  const auto end = words.find_first_of(" :", name);
  return words.replace(name, end == std::string::npos ? end : end - name, "this file");
}

/// A colour channel as scanners write it: a display value, not light.
std::uint8_t eight_bits(float share) {
  const float whole = 255.0f * share + 0.5f;
  return whole > 0.0f ? static_cast<std::uint8_t>(whole < 255.0f ? whole : 255.0f)
                      : std::uint8_t{0};
}

/// The triangles of one node's meshes, and their colours if all of them have some.
MeshPart part_of(const aiScene& scene, const aiNode& node) {
  MeshPart part;
  bool colored = node.mNumMeshes > 0;
  for (unsigned m = 0; m < node.mNumMeshes; ++m)
    colored = colored && scene.mMeshes[node.mMeshes[m]]->HasVertexColors(0);
  part.name = node.mName.C_Str();
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
    const auto base = static_cast<std::uint32_t>(part.positions.size());
    for (unsigned i = 0; i < mesh.mNumVertices; ++i)
      part.positions.push_back({mesh.mVertices[i].x, mesh.mVertices[i].y, mesh.mVertices[i].z});
    for (unsigned i = 0; colored && i < mesh.mNumVertices; ++i) {
      const aiColor4D& c = mesh.mColors[0][i];
      part.colors.push_back({eight_bits(c.r), eight_bits(c.g), eight_bits(c.b)});
    }
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace& face = mesh.mFaces[i];
      if (face.mNumIndices != 3) continue;
      part.triangles.push_back(
          {base + face.mIndices[0], base + face.mIndices[1], base + face.mIndices[2]});
    }
  }
  return part;
}

int read(const std::string& ending, std::size_t vertices, std::size_t triangles) {
  const auto bytes = onggi::files::standard_input();
  Assimp::Importer importer;
  importer.SetIOHandler(new NoFiles);  // owned by the importer
  leave_only(importer, ending);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                              aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* scene =
      bytes.empty() ? nullptr
                    : importer.ReadFileFromMemory(bytes.data(), bytes.size(),
                                                  aiProcess_Triangulate | aiProcess_SortByPType |
                                                      aiProcess_JoinIdenticalVertices,
                                                  ending.c_str());
  const auto answer = [](const std::vector<std::byte>& out) {
    return std::fwrite(out.data(), 1, out.size(), stdout) == out.size() && std::fflush(stdout) == 0
               ? 0
               : 1;
  };
  if (scene == nullptr || scene->mRootNode == nullptr)
    return answer(onggi::content::refusal_bytes(
        bytes.empty() ? "it is empty" : without_its_name(importer.GetErrorString())));
  std::vector<MeshPart> parts;
  std::vector<const aiNode*> stack{scene->mRootNode};
  std::size_t all_vertices = 0, all_triangles = 0;
  while (!stack.empty()) {
    const aiNode& node = *stack.back();
    stack.pop_back();
    for (unsigned i = node.mNumChildren; i-- > 0;) stack.push_back(node.mChildren[i]);
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
      all_vertices += scene->mMeshes[node.mMeshes[m]]->mNumVertices;
      all_triangles += scene->mMeshes[node.mMeshes[m]]->mNumFaces;
    }
    if (all_vertices > vertices || all_triangles > triangles)
      return answer(
          onggi::content::refusal_bytes("it has more than " + std::to_string(vertices) +
                                        " vertices or " + std::to_string(triangles) +
                                        " triangles: export it with fewer, or raise "
                                        "vertices or triangles in the exhibit's [reader]"));
    MeshPart part = part_of(*scene, node);
    if (!part.triangles.empty()) parts.push_back(std::move(part));
  }
  return answer(onggi::content::parts_bytes(parts));
}

}  // namespace

int main(int count, char** words) {
  if (count != 6) {
    std::fputs("usage: onggi-mesh ENDING VERTICES TRIANGLES MEMORY_MIB SECONDS", stderr);
    return 1;
  }
  // Assimp loops forever on some damaged files.
  onggi::files::confine(std::strtoul(words[4], nullptr, 10), std::strtoul(words[5], nullptr, 10),
                        "reading the file takes longer than allowed");
  try {
    return read(words[1], std::strtoul(words[2], nullptr, 10), std::strtoul(words[3], nullptr, 10));
  } catch (const std::bad_alloc&) {
    std::fputs("it needs more memory than allowed", stderr);
  }
  return 1;
}
