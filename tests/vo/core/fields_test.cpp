#include "vo/core/fields.h"

#include <array>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "vo/core/error.h"

namespace {

enum class Colour { red, green };

constexpr auto enum_names(Colour) {
  return std::array{std::pair{Colour::red, "red"}, std::pair{Colour::green, "green"}};
}

struct Inner {
  int count = 3;
  double length = 0.1;
};

template <typename Visitor>
void visit_fields(Visitor& visit, Inner& inner) {
  visit("count", inner.count, "a number");
  visit("length", inner.length, "m");
}

struct Outer {
  bool flag = false;
  Colour colour = Colour::red;
  Eigen::Vector3d centre = {1, 2.5, -3};
  Inner inner;
};

template <typename Visitor>
void visit_fields(Visitor& visit, Outer& outer) {
  visit("flag", outer.flag, "a switch");
  visit("colour", outer.colour, "a choice");
  visit("centre", outer.centre, "m");
  visit("inner", outer.inner, "");
}

std::string error_of(std::vector<vo::Field>& fields, const std::string& key,
                     const std::string& text) {
  try {
    vo::set_field(fields, key, text);
  } catch (const vo::Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Fields, EveryValueReadsBackFromItsText) {
  Outer outer;
  outer.inner.length = 1.0 / 3;
  outer.colour = Colour::green;
  Outer copy;
  std::vector<vo::Field> from = vo::fields_of(outer);
  std::vector<vo::Field> to = vo::fields_of(copy);
  for (std::size_t i = 0; i < from.size(); ++i) {
    to[i].set(from[i].get());
    EXPECT_EQ(to[i].get(), from[i].get());
  }
  EXPECT_EQ(copy.inner.length, outer.inner.length) << "to the last bit";
  EXPECT_EQ(copy.colour, Colour::green);
}

TEST(Fields, KeysAreDottedPaths) {
  Outer outer;
  std::vector<std::string> keys;
  for (const vo::Field& field : vo::fields_of(outer, "x.")) {
    keys.push_back(field.key);
  }
  EXPECT_THAT(keys, testing::ElementsAre("x.flag", "x.colour", "x.centre", "x.inner.count",
                                         "x.inner.length"));
}

TEST(Fields, ErrorsNameKeyAndExpectation) {
  Outer outer;
  std::vector<vo::Field> fields = vo::fields_of(outer);
  EXPECT_EQ(error_of(fields, "inner.cuont", "1"),
            "unknown key 'inner.cuont'; the nearest known key is inner.count");
  EXPECT_EQ(error_of(fields, "inner.count", "1.5"),
            "inner.count: expected a whole number, got '1.5'");
  EXPECT_EQ(error_of(fields, "inner.length", "nan"), "inner.length: expected a number, got 'nan'");
  EXPECT_EQ(error_of(fields, "flag", "yes"), "flag: expected true or false, got 'yes'");
  EXPECT_EQ(error_of(fields, "colour", "blue"), "colour: expected one of red, green, got 'blue'");
  EXPECT_EQ(error_of(fields, "centre", "1,2"),
            "centre: expected 3 numbers with commas between, got '1,2'");
}

TEST(Fields, NothingNearMeansNoSuggestion) {
  EXPECT_EQ(vo::nearest_key("zzzzzz", {"count", "length"}), "");
  EXPECT_EQ(vo::nearest_key("cout", {"count", "length"}), "count");
}

struct Map {
  Inner host;
};

template <typename Visitor>
void visit_fields(Visitor& visit, Map& map) {
  visit("host", map.host, "");
}

TEST(Fields, OldSpellingsOfKeysStillSetTheirFields) {
  Map map;
  std::vector<vo::Field> fields = vo::fields_of(map, "depth_map.");
  EXPECT_EQ(vo::current_key("depth_map.anchor.count"), "depth_map.host.count");
  EXPECT_EQ(vo::current_key("inner.count"), "inner.count");
  vo::set_field(fields, "depth_map.anchor.count", "7");
  EXPECT_EQ(map.host.count, 7);
}

}  // namespace
