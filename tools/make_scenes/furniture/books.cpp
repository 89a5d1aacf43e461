#include "tools/make_scenes/furniture/books.h"

#include <array>
#include <cstddef>

#include "tools/make_scenes/painting/noise.h"
#include "tools/make_scenes/painting/picture_patterns.h"

namespace scenes {
namespace {

struct Book {
  Eigen::Vector3d size;  ///< thickness, height, depth; m
  Color color;           ///< linear RGB
  int spine = 0;         ///< index of the spine in the texture
};

Book random_book(std::uint32_t seed, int i) {
  constexpr std::array<std::uint32_t, 10> kDyes = {0x9c3b32, 0x2f5373, 0x3e6b4a, 0xc79a3e,
                                                   0x5a4a72, 0xd8cdb4, 0x38393f, 0xb5643a,
                                                   0x6f8f9e, 0x7d2e46};
  const auto pick = static_cast<std::size_t>(10 * random01(seed, i, 3));
  const Color dye = rgb(kDyes.at(pick)) * (0.85 + 0.3 * random01(seed, i, 4));
  return {
      {0.016 + 0.034 * random01(seed, i, 0) * random01(seed, i, 5) + 0.01 * random01(seed, i, 6),
       0.2 + 0.1 * random01(seed, i, 1), 0.14 + 0.07 * random01(seed, i, 2)},
      dye.cwiseProduct(dye).cwiseMin(1.0),
      static_cast<int>(kBookSpines * random01(seed, i, 7))};
}

/// Adds an upright book, its spine around the origin in the plane z = 0.
void add_book(Mesh& mesh, const Book& book, const Eigen::Isometry3d& T_mesh_book) {
  const Eigen::Vector3d& size = book.size;
  const Eigen::Isometry3d center = T_mesh_book * at(0, 0, -size.z() / 2);
  for (const double side : {-1.0, 1.0}) {
    add(mesh, Finish::paint, painted(box({0.003, size.y(), size.z() - 0.001}), book.color),
        center * at(side * (size.x() / 2 - 0.0015), 0, -0.0005));
  }
  add(mesh, Finish::paper, box({size.x() - 0.0064, size.y() - 0.008, size.z() - 0.008}),
      center * at(0, 0, 0.001));
  Shape spine = panel(size.x(), size.y());
  for (Eigen::Vector2d& texcoord : spine.texcoords) {
    texcoord.x() = (book.spine + 0.04 + 0.92 * texcoord.x()) / kBookSpines;
  }
  add(mesh, Finish::book_spines, painted(spine, book.color), T_mesh_book);
}

}  // namespace

Mesh book_row(const std::string& name, double length, std::uint32_t seed) {
  Mesh mesh = {name, {}};
  double x = -length / 2;
  for (int i = 0; x < length / 2 - 0.06; ++i) {
    const Book book = random_book(seed, i);
    const bool gap = random01(seed, i, 8) < 0.05;
    const double setback = 0.025 * random01(seed, i, 9);
    x += book.size.x() + 0.0012;
    add_book(mesh, book, at(x - book.size.x() / 2, book.size.y() / 2 + 0.001, -setback));
    x += gap ? 0.05 : 0;
  }
  return mesh;
}

Mesh book_stack(const std::string& name, int count, std::uint32_t seed) {
  Mesh mesh = {name, {}};
  double y = 0.001;
  for (int i = 0; i < count; ++i) {
    const Book book = random_book(seed, i);
    const double turn = 24 * (random01(seed, i, 10) - 0.5);
    const Eigen::Isometry3d lying =
        at(0, y + book.size.x() / 2, 0) * about_y(turn) * at(0, 0, book.size.z() / 2) * about_z(90);
    add_book(mesh, book, lying);
    y += book.size.x() + 0.001;
  }
  return mesh;
}

Mesh open_book() {
  Mesh mesh = {"open_book", {}};
  add(mesh, Finish::paint, painted(box({0.32, 0.004, 0.23}, 0.001), {0.25, 0.07, 0.06}),
      at(0, 0.003, 0));
  for (const double side : {-1.0, 1.0}) {
    const auto page = [side](double u, double v) {
      const double x = side > 0 ? u : 1 - u;
      return Eigen::Vector3d(side * (0.002 + 0.15 * x), 0.008 + 0.05 * x * (1 - x) * (1 - x),
                             0.22 * (v - 0.5));
    };
    add(mesh, Finish::print, sheet(page, {8, 1, {1, 1}}));
  }
  return mesh;
}

}  // namespace scenes
