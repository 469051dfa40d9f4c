#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <span>

#include "kiosk/ground/web/received_file.h"
#include "tests/kiosk/program/console/staff_page.h"

// Who may send files to the page, and what else is for editors alone.
namespace onggi::console::staff_uploads_test {
namespace {

using namespace test;
using ::testing::HasSubstr;

class StaffUploads : public StaffPage {
 protected:
  web::Ask sending() const {
    web::Ask ask = posting("/api/upload?name=jar.obj&first=1");
    ask.type = "application/octet-stream";
    ask.body = "";
    ask.length = 4;
    return ask;
  }
  /// The status of a refusal; 200 where the file may come, 0 where it goes into memory.
  int place(const web::Ask& ask) const {
    const web::BodyPlace place = staff_->place_for_body(ask);
    if (const auto* refused = std::get_if<web::Answer>(&place)) return refused->status;
    return std::holds_alternative<web::IntoFile>(place) ? 200 : 0;
  }
  void come_in_as(const std::string& role) {
    add("maria", role);
    add("joon", "editor");
    cookie_ = "";
    enter("maria", "a passphrase of maria");
  }
};

TEST_F(StaffUploads, AFileComesFromAnEditorAloneByThePageItselfAndIsRefusedBeforeItIsRead) {
  EXPECT_EQ(place(sending()), 200);
  web::Ask elsewhere = sending(), form = sending(), host = sending(), stranger = sending(),
           read = sending();
  elsewhere.origin = "http://evil.example";
  form.type = "application/json";
  host.host = "evil.example";
  stranger.cookie = "";
  read.method = "PUT";
  EXPECT_EQ(place(elsewhere), 403);
  EXPECT_EQ(place(form), 415);
  EXPECT_EQ(place(host), 421);
  EXPECT_EQ(place(stranger), 401);
  EXPECT_EQ(place(read), 0) << "as any other request";
  EXPECT_EQ(place(posting("/api/scan/look")), 0);
  EXPECT_EQ(place(posting("/api/uploads")), 0);
  come_in_as("desk");
  EXPECT_EQ(place(sending()), 403);
}

TEST_F(StaffUploads, AFileThatArrivedIsTakenUnderItsNameAndRefusedUnderOneThatLeadsOut) {
  for (const auto& [name, status] : {std::pair{"jar.obj", 200}, {"..%2Fjar.obj", 409}}) {
    const web::BodyPlace place = staff_->place_for_body(sending());
    const auto* into = std::get_if<web::IntoFile>(&place);
    ASSERT_NE(into, nullptr);
    auto file = web::ReceivedFile::make(*into);
    ASSERT_TRUE(file);
    (*file)->append(std::as_bytes(std::span("clay", 4)));
    web::Ask ask = sending();
    ask.target = std::string("/api/upload?first=1&name=") + name;
    ask.file = *file;
    EXPECT_EQ(staff_->to(ask).status, status) << name;
  }
  EXPECT_TRUE(fs::exists(state_ / "scans/scan/jar.obj"));
  web::Ask of_another = sending();
  of_another.target = "/api/upload?name=jar.mtl&scan=7";
  of_another.file = *web::ReceivedFile::make({.folder = state_ / "scans"});
  EXPECT_EQ(staff_->to(of_another).status, 412);
  EXPECT_THAT(get("/api/scan").body, HasSubstr("\"files\":1"));
  EXPECT_EQ(staff_->to(sending()).status, 409) << "no file came";
  EXPECT_EQ(post("/api/scan/forget").status, 200);
  EXPECT_FALSE(fs::exists(state_ / "scans/scan"));
}

TEST_F(StaffUploads, AChoiceThatIsNoneBeginsNothing) {
  for (const char* body :
       {"{}", "[]", "x", R"({"vessel": -1, "id": "jar"})", R"({"vessel": 0, "id": 5})",
        R"({"vessel": "0", "id": "jar"})", R"({"vessel": 0, "id": "jar", "height_mm": -1})"})
    EXPECT_EQ(post("/api/scan/place", body).status, 409) << body;
  EXPECT_EQ(post("/api/scan/place", R"({"vessel": 0, "id": "jar"})").status, 503);
  EXPECT_EQ(post("/api/scan/else").status, 404);
  // Somebody else has sent another one since.
  for (const char* act : {"look", "place", "forget"})
    EXPECT_EQ(
        post(std::string("/api/scan/") + act, R"({"scan": 7, "vessel": 0, "id": "jar"})").status,
        412)
        << act;
}

TEST_F(StaffUploads, ScenesScansAndSheetsAreForEditors) {
  come_in_as("desk");
  for (const char* target : {"/api/scenes", "/api/prices/studio", "/api/scan", "/sheet/jar",
                             "/api/edit/scene/studio", "/api/edit/language/en"})
    EXPECT_EQ(get(target).status, 403) << target;
  for (const char* target : {"/api/prices/studio", "/api/scan/look", "/api/scan/place",
                             "/api/scan/forget", "/api/upload?name=x"})
    EXPECT_EQ(post(target).status, target == std::string("/api/upload?name=x") ? 415 : 403)
        << target;
  cookie_ = "";
  for (const char* target : {"/api/scenes", "/api/prices/studio", "/api/scan", "/sheet/jar"})
    EXPECT_EQ(get(target).status, 401) << target;
}

}  // namespace
}  // namespace onggi::console::staff_uploads_test
