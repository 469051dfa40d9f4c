#include "kiosk/exhibit/composition/card_picture.h"

#include <gtest/gtest.h>

#include "kiosk/picture/render/portrait.h"
#include "tests/kiosk/exhibit/composition/no_renderer.h"

namespace onggi::exhibit::card_picture_test {
namespace {

/// Writes down what a frame has to do. A picture's number is how many corners its mesh has.
class Painter final : public test::NoRenderer {
 public:
  std::shared_ptr<const render::Portrait> prepare_picture(const TriangleMesh& mesh,
                                                          std::array<float, 3>,
                                                          const content::Coloring&, int,
                                                          int) override {
    ++uploads;
    auto portrait = std::make_shared<render::Portrait>();
    portrait->model.radius = static_cast<float>(mesh.positions.size());
    return portrait;
  }
  view::PictureId draw_picture(const render::Portrait& portrait) override {
    ++drawn;
    return static_cast<view::PictureId>(portrait.model.radius);
  }
  int uploads = 0, drawn = 0;
};

content::Vessel vessel_of(std::size_t corners) {
  content::Vessel out;
  out.mesh.positions.resize(corners);
  return out;
}

TEST(CardPicture, OneFrameUploadsTheVesselAndTheNextDrawsIt) {
  Painter painter;
  CardPicture picture;
  const content::Vessel jar = vessel_of(7);
  EXPECT_EQ(picture.next(painter, jar), 0u);
  EXPECT_EQ(painter.uploads, 1);
  EXPECT_EQ(painter.drawn, 0);
  EXPECT_EQ(picture.next(painter, jar), 7u);
  EXPECT_EQ(painter.uploads, 1) << "the frame that draws it uploaded it, too";
}

TEST(CardPicture, AVesselNeverGetsThePictureOfAnother) {
  Painter painter;
  CardPicture picture;
  const content::Vessel jar = vessel_of(7), bowl = vessel_of(9);
  picture.next(painter, jar);
  EXPECT_EQ(picture.next(painter, bowl), 0u);
  EXPECT_EQ(picture.next(painter, bowl), 9u);
  EXPECT_EQ(picture.next(painter, jar), 0u);
  EXPECT_EQ(picture.next(painter, jar), 7u);
}

}  // namespace
}  // namespace onggi::exhibit::card_picture_test
