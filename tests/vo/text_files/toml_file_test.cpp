#include "vo/text_files/toml_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"
#include "vo/files/output.h"

namespace {

using support::error_text;
using support::TempFolder;
using testing::EndsWith;
using testing::HasSubstr;

struct Settings {
  int count = 1;
  double size = 2;
  bool flag = false;
  std::string name = "a";
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  std::vector<Eigen::Vector3d> points;
};

template <typename Visitor>
void visit_fields(Visitor& visit, Settings& settings) {
  visit("count", settings.count, "");
  visit("size", settings.size, "");
  visit("flag", settings.flag, "");
  visit("name", settings.name, "");
  visit("centre", settings.centre, "");
  visit("points", settings.points, "");
}

Settings read(const std::string& text) {
  const TempFolder folder;
  vo::write_file(folder.path() / "s.toml", text);
  Settings settings;
  std::vector<vo::Field> fields = vo::fields_of(settings, "top.");
  vo::assign_fields(vo::read_toml(folder.path() / "s.toml"), fields);
  return settings;
}

std::string error_of(const std::string& text) {
  return error_text([&] { read(text); });
}

TEST(TomlFile, AssignsTablesDottedKeysAndArrays) {
  const Settings settings = read(
      "[top]\ncount = 7\nsize = 3\nflag = true\nname = 'b'\ncentre = [1, 2.5, -3]\n"
      "points = [[1, 2, 3],\n [4, 5, 6]]\n");
  EXPECT_EQ(settings.count, 7);
  EXPECT_EQ(settings.size, 3) << "a whole number is a number";
  EXPECT_TRUE(settings.flag);
  EXPECT_EQ(settings.name, "b");
  EXPECT_EQ(settings.centre, Eigen::Vector3d(1, 2.5, -3));
  ASSERT_EQ(settings.points.size(), 2U);
  EXPECT_EQ(settings.points[1], Eigen::Vector3d(4, 5, 6));
}

TEST(TomlFile, ArraysOfTablesAndTextsAreFlattenedByNumber) {
  const TempFolder folder;
  const auto file = folder.write("s.toml",
                                 "[[class]]\nname = 'a'\nnodes = ['x', 'y']\nsizes = [1, 2]\n"
                                 "[[class]]\nnodes = []\n");
  std::vector<std::string> read;
  for (const vo::TomlValue& value : vo::read_toml(file)) {
    read.push_back(
        vo::concat(value.place.substr(value.place.rfind(':')), " ", value.key, " ", value.text));
  }
  EXPECT_THAT(read, testing::ElementsAre(":2 class.0.name a", ":3 class.0.nodes.0 x",
                                         ":3 class.0.nodes.1 y", ":4 class.0.sizes 1,2",
                                         ":6 class.1.nodes "));
  EXPECT_THAT(error_of("[top]\n[[other]]\n"),
              EndsWith("s.toml:2: other: is an empty table, expected values"));
}

TEST(TomlFile, FormatReadsBack) {
  Settings settings;
  settings.size = 0.1;
  settings.name = "say \"hi\" \\";
  settings.points = {{1, 2, 3}};
  const Settings copy = read(vo::format_toml(vo::fields_of(settings, "top.")));
  EXPECT_EQ(copy.size, settings.size);
  EXPECT_EQ(copy.name, settings.name);
  EXPECT_EQ(copy.points, settings.points);
}

TEST(TomlFile, AnyTextIsValidToml) {
  Settings settings;
  settings.name = "a\tb\n\x7f \u00e9";
  const Settings copy = read(vo::format_toml(vo::fields_of(settings, "top.")));
  EXPECT_EQ(copy.name, settings.name);
  EXPECT_EQ(vo::quoted_toml("bad\xff.gltf"), "\"bad\uFFFD.gltf\"");
}

TEST(TomlFile, ErrorsNameFileLineAndNearestKey) {
  EXPECT_THAT(error_of("[top]\ncount = 1\nsiez = 2\n"),
              EndsWith("s.toml:3: unknown key 'top.siez'; the nearest known key is top.size"));
  EXPECT_THAT(error_of("[top]\nsize = 'big'\n"),
              EndsWith("s.toml:2: top.size: expected a number, got \"big\""));
  EXPECT_THAT(error_of("[top]\ncount = 1.5\n"),
              EndsWith("s.toml:2: top.count: expected a whole number, got 1.5"));
  EXPECT_THAT(error_of("[top]\nname = 3\n"),
              EndsWith("s.toml:2: top.name: expected a text in quotes, got 3"));
  EXPECT_THAT(
      error_of("[top]\nname = \"a\\u0000b\"\n"),
      EndsWith("s.toml:2: top.name: holds the character U+0000, expected a text without it"));
  EXPECT_THAT(error_of("[top]\ncentre = [1, 'a', 2]\n"),
              EndsWith("s.toml:2: top.centre: expected an array of numbers"));
}

TEST(TomlFile, WhatIsNoTomlNamesLineAndColumn) {
  EXPECT_THAT(error_of("[top]\ncount = = 3\n"), HasSubstr("s.toml:2:9: "));
  EXPECT_THAT(error_of("[top]\ncount = 1\ncount = 2\n"), HasSubstr("s.toml:3:"));
}

TEST(TomlFile, TablesOfArraysAreReadApartInTheirOrder) {
  const TempFolder folder;
  const vo::TomlRecords file = vo::read_toml_records(
      folder.write("s.toml",
                   "a.b = 1\n[[item]]\nsize = 2.0\n[item.part]\nname = \"x\"\n[[item]]\n"
                   "[[thing]]\nsize = 3\n"),
      {"item", "thing", "other"});
  ASSERT_EQ(file.others.size(), 1U);
  EXPECT_EQ(file.others[0].key, "a.b");
  const std::vector<vo::TomlRecord>& items = file.arrays.at("item");
  ASSERT_EQ(items.size(), 2U);
  EXPECT_THAT(items[0].place, EndsWith("s.toml:2"));
  ASSERT_EQ(items[0].values.size(), 2U);
  EXPECT_EQ(items[0].values[0].key, "part.name");
  EXPECT_THAT(items[0].values[0].place, EndsWith("s.toml:5"));
  EXPECT_EQ(items[0].values[1].text, "2");
  EXPECT_EQ(vo::format_toml(items[0].values[1]), "size = 2.0\n");
  EXPECT_TRUE(items[1].values.empty());
  ASSERT_EQ(file.arrays.at("thing").size(), 1U);
  EXPECT_THAT(file.arrays.at("thing")[0].place, EndsWith("s.toml:7"));
  EXPECT_TRUE(file.arrays.at("other").empty());
}

}  // namespace
