#include "synth/path_planning/roadmap.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "vo/core/error.h"
#include "vo/core/hash.h"
#include "vo/core/median.h"

namespace synth {
namespace {

using Eigen::Vector3d;

enum Draw : std::uint64_t { region_draw = 11, place_draw = 12, target_draw = 13, room_draw = 14 };

Eigen::Vector4d random_shares(std::uint64_t seed, std::uint64_t draw, std::uint64_t index) {
  Eigen::Vector4d shares;
  for (int i = 0; i < 4; ++i) {
    shares[i] = vo::random_uniform({seed, draw, index, static_cast<std::uint64_t>(i)});
  }
  return shares;
}

Vector3d random_place(const Eigen::AlignedBox3d& box, const Eigen::Vector4d& shares) {
  return box.min() + shares.head<3>().cwiseProduct(box.sizes());
}

/// Returns whether a position is indoors: hardly a ray escapes to the sides and below (models may
/// be open above), and most hits are fronts, unlike within a closed solid.
bool is_inside(const Surroundings& around) {
  return around.level_share > 0.9 && around.front_share > 0.5;
}

bool is_outside(const Surroundings& around) {
  return around.hit_share > 0.08 && around.front_share > 0.5;
}

bool belongs(const Surroundings& around, const ExploredRegion& region) {
  constexpr double kHall = 3;  // in scales; beyond is the space between a house and its sky
  return region.is_inside ? is_inside(around) && around.far_distance < kHall * region.scale
                          : is_outside(around);
}

/// Returns whether a position indoors is neither close to the ceiling nor to the floor.
bool is_at_eye_level(const FreeSpace& space, const Vector3d& place, const ExploredRegion& region) {
  const double down = space.distance_along(place, -Vector3d::UnitY());
  const double up = space.distance_along(place, Vector3d::UnitY());
  if (!region.is_inside || down == 0) {
    return true;
  }
  const double room = up > 0 ? std::min(down + up, 2 * region.scale) : 2 * region.scale;
  return down > 0.3 * room && down < 0.75 * room;
}

constexpr std::size_t kEnough = 60;
constexpr std::size_t kLeast = 20;

/// Returns Surroundings::far_distance, m, of random positions in the region; fewer than `kLeast`
/// where the region hardly exists.
std::vector<double> distances_in(const FreeSpace& space, const ExploredRegion& region,
                                 std::uint64_t seed) {
  constexpr std::uint64_t kTries = 4000;
  std::vector<double> distances;
  for (std::uint64_t i = 0; i < kTries && distances.size() < kEnough; ++i) {
    const Surroundings around =
        space.look_around(random_place(region.box, random_shares(seed, region_draw, i)));
    if (region.is_inside ? is_inside(around) : is_outside(around)) {
      distances.push_back(around.far_distance);
    }
  }
  return distances;
}

/// Returns Surroundings::far_distance, m, of rooms; empty if few positions by surfaces are in
/// rooms.
std::vector<double> distances_in_rooms(const FreeSpace& space, std::uint64_t seed) {
  constexpr std::uint64_t kTries = 5 * kEnough;
  std::vector<double> distances;
  for (std::uint64_t i = 0; i < kTries; ++i) {
    const Surroundings around =
        space.look_around(space.beside_surface(random_shares(seed, room_draw, i)));
    const bool is_room = around.far_distance > 1 && around.far_distance < 10;  // m
    if (is_room && is_inside(around)) {
      distances.push_back(around.far_distance);
    }
  }
  return distances.size() >= kEnough ? distances : std::vector<double>();
}

std::vector<Vector3d> free_places(const FreeSpace& space, const ExploredRegion& region,
                                  double radius, std::uint64_t seed) {
  constexpr std::uint64_t kTries = 60000;
  constexpr std::size_t kWanted = 240;
  std::vector<Vector3d> places;
  for (std::uint64_t i = 0; i < kTries && places.size() < kWanted; ++i) {
    const Eigen::Vector4d shares = random_shares(seed, place_draw, i);
    const Vector3d place =
        i % 2 == 0 ? random_place(region.box, shares) : space.beside_surface(shares);
    if (space.clearance(place, 2 * radius) >= radius && is_at_eye_level(space, place, region) &&
        belongs(space.look_around(place), region)) {
      places.push_back(place);
    }
  }
  return places;
}

std::vector<std::size_t> nearest_places(const std::vector<Vector3d>& places, std::size_t from) {
  constexpr std::size_t kNeighbours = 10;
  std::vector<std::pair<double, std::size_t>> ranked;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i != from) {
      ranked.emplace_back((places[i] - places[from]).norm(), i);
    }
  }
  const std::size_t count = std::min(kNeighbours, ranked.size());
  std::partial_sort(ranked.begin(), ranked.begin() + static_cast<std::ptrdiff_t>(count),
                    ranked.end());
  std::vector<std::size_t> nearest;
  for (std::size_t i = 0; i < count; ++i) {
    nearest.push_back(ranked[i].second);
  }
  return nearest;
}

Roadmap connected(std::vector<Vector3d> places, const FreeSpace& space, double radius) {
  Roadmap roadmap{std::move(places), {}};
  roadmap.ways.resize(roadmap.places.size());
  for (std::size_t i = 0; i < roadmap.places.size(); ++i) {
    for (const std::size_t j : nearest_places(roadmap.places, i)) {
      const bool known = std::any_of(roadmap.ways[i].begin(), roadmap.ways[i].end(),
                                     [&](const Roadmap::Way& way) { return way.to == j; });
      if (!known && space.is_free(roadmap.places[i], roadmap.places[j], radius)) {
        const double length = (roadmap.places[i] - roadmap.places[j]).norm();
        roadmap.ways[i].push_back({j, length});
        roadmap.ways[j].push_back({i, length});
      }
    }
  }
  return roadmap;
}

/// Returns the places that can be reached from a place, itself included.
std::vector<std::size_t> reachable(const Roadmap& roadmap, std::size_t from) {
  std::vector<bool> is_known(roadmap.places.size(), false);
  std::vector<std::size_t> found = {from};
  is_known[from] = true;
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (const Roadmap::Way& way : roadmap.ways[found[i]]) {
      if (!is_known[way.to]) {
        is_known[way.to] = true;
        found.push_back(way.to);
      }
    }
  }
  return found;
}

Roadmap largest_part(const Roadmap& roadmap) {
  std::vector<std::size_t> best;
  for (std::size_t i = 0; i < roadmap.places.size() && 2 * best.size() < roadmap.places.size();
       ++i) {
    std::vector<std::size_t> part = reachable(roadmap, i);
    if (part.size() > best.size()) {
      best = std::move(part);
    }
  }
  std::sort(best.begin(), best.end());
  Roadmap result;
  for (const std::size_t from : best) {
    result.places.push_back(roadmap.places[from]);
    result.ways.emplace_back();
    for (const Roadmap::Way& way : roadmap.ways[from]) {
      const auto to = std::lower_bound(best.begin(), best.end(), way.to);
      result.ways.back().push_back({static_cast<std::size_t>(to - best.begin()), way.length});
    }
  }
  return result;
}

/// Returns the places after `from` on the shortest path to `to`, by Dijkstra's algorithm.
std::vector<std::size_t> shortest_way(const Roadmap& roadmap, std::size_t from, std::size_t to) {
  using Entry = std::pair<double, std::size_t>;
  std::vector<double> distances(roadmap.places.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> next(roadmap.places.size(), to);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  distances[to] = 0;  // search from the end, so that `next` leads forwards
  queue.emplace(0, to);
  while (!queue.empty()) {
    const auto [distance, place] = queue.top();
    queue.pop();
    for (const Roadmap::Way& way : roadmap.ways[place]) {
      if (distance == distances[place] && distance + way.length < distances[way.to]) {
        distances[way.to] = distance + way.length;
        next[way.to] = place;
        queue.emplace(distances[way.to], way.to);
      }
    }
  }
  std::vector<std::size_t> result;
  for (std::size_t place = from; place != to;) {
    place = next[place];
    result.push_back(place);
  }
  return result;
}

double distance_to(const std::vector<Vector3d>& visited, const Vector3d& place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vector3d& other : visited) {
    nearest = std::min(nearest, (other - place).norm());
  }
  return nearest;
}

/// Returns the one of some random places that is farthest from those visited.
std::size_t next_target(const Roadmap& roadmap, const std::vector<Vector3d>& visited,
                        std::uint64_t seed, std::uint64_t leg) {
  constexpr std::uint64_t kCandidates = 8;
  std::size_t best = 0;
  double farthest = -1;
  for (std::uint64_t i = 0; i < kCandidates; ++i) {
    const auto place = static_cast<std::size_t>(vo::random_uniform({seed, target_draw, leg, i}) *
                                                static_cast<double>(roadmap.places.size()));
    const double distance = distance_to(visited, roadmap.places[place]);
    if (distance > farthest) {
      best = place;
      farthest = distance;
    }
  }
  return best;
}

}  // namespace

ExploredRegion find_region(const FreeSpace& space, std::uint64_t seed) {
  constexpr double kSky = 20;  // m, scale above which an inside is hardly a building's
  ExploredRegion inner{space.bounds(), true, 0};
  const std::vector<double> inside = distances_in(space, inner, seed);
  if (inside.size() >= kLeast) {
    inner.scale = vo::upper_median(inside);
    const std::vector<double> rooms =
        inner.scale > kSky ? distances_in_rooms(space, seed) : std::vector<double>();
    inner.scale = rooms.empty() ? inner.scale : vo::upper_median(rooms);
    return inner;
  }
  ExploredRegion outer{space.bounds(), false, 0};
  const Vector3d margin = Vector3d::Constant(outer.box.diagonal().norm() / 2);
  outer.box = Eigen::AlignedBox3d(outer.box.min() - margin, outer.box.max() + margin);
  outer.box.min().y() = space.bounds().min().y();
  const std::vector<double> outside = distances_in(space, outer, seed);
  vo::require(outside.size() >= kLeast,
              "explore: found no place from which the scene's surfaces can be seen");
  outer.scale = vo::upper_median(outside);
  return outer;
}

Roadmap make_roadmap(const FreeSpace& space, const ExploredRegion& region, double radius,
                     std::uint64_t seed) {
  const Roadmap roadmap =
      largest_part(connected(free_places(space, region, radius, seed), space, radius));
  return roadmap.places.size() < 2 ? Roadmap{} : roadmap;
}

std::vector<Vector3d> wander(const Roadmap& roadmap, double length, std::uint64_t seed) {
  std::size_t here = next_target(roadmap, {}, seed, 0);
  std::vector<Vector3d> way = {roadmap.places[here]};
  double walked = 0;
  for (std::uint64_t leg = 1; walked < length; ++leg) {
    const std::size_t target = next_target(roadmap, way, seed, leg);
    for (const std::size_t place : shortest_way(roadmap, here, target)) {
      walked += (roadmap.places[place] - way.back()).norm();
      way.push_back(roadmap.places[place]);
    }
    here = target;
  }
  return way;
}

}  // namespace synth
