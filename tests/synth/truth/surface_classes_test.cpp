#include "synth/truth/surface_classes.h"

#include <fnmatch.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "synth/truth/name_pattern.h"
#include "tests/support/error_text.h"

namespace synth {
namespace {

using testing::ElementsAre;

/// All texts of up to `length` characters of an alphabet.
std::vector<std::string> texts_of(const std::string& alphabet, std::size_t length) {
  std::vector<std::string> texts{""};
  for (std::size_t begin = 0, round = 0; round < length; ++round) {
    const std::size_t end = texts.size();
    for (; begin < end; ++begin) {
      for (const char c : alphabet) {
        texts.push_back(texts[begin] + c);
      }
    }
  }
  return texts;
}

TEST(NamePattern, IsThatOfPosixOnEveryShortText) {
  const std::vector<std::string> names = texts_of("a/b", 5);
  for (const std::string& pattern : texts_of("a/*?", 5)) {
    for (const std::string& name : names) {
      ASSERT_EQ(matches(pattern, name), fnmatch(pattern.c_str(), name.c_str(), 0) == 0)
          << pattern << " and " << name;
    }
  }
}

TEST(NamePattern, AQuestionMarkIsOneCharacterAndABracketIsItself) {
  EXPECT_TRUE(matches("l?g", "l\u00e9g"));
  EXPECT_FALSE(matches("l??g", "l\u00e9g"));
  EXPECT_TRUE(matches("a[1]", "a[1]"));
  EXPECT_FALSE(matches("a[1]", "a1"));
}

TEST(NamePattern, TakesNoLongerThanTheProductOfTheLengths) {
  const std::string name(20'000, 'a');
  EXPECT_FALSE(matches("*a*a*a*a*a*a*a*a*b", name));
}

/// A hall (node 0) with a chair (1) of a cushion (2) and a node without a name (3). The instances
/// show these by two materials and none.
struct Hall {
  Scene scene;
  SceneLabels labels;
};

Hall hall() {
  Hall hall;
  for (const char* name : {"wood", "cloth"}) {
    hall.scene.materials.emplace_back().name = name;
  }
  for (const int material : {0, 1, kNone}) {
    hall.scene.meshes.emplace_back().material = material;
  }
  hall.labels.files.push_back({.nodes = {{"hall", kNone}, {"chair", 0}, {"cushion", 1}, {"", 0}}});
  const auto show = [&](int node, int mesh) {
    hall.scene.instances.emplace_back().mesh = mesh;
    hall.labels.instances.push_back({.node = node, .mesh = mesh});
  };
  show(1, 0);
  show(2, 1);
  show(3, 2);
  show(3, 0);
  return hall;
}

std::vector<std::uint16_t> instances_of(const std::vector<SurfaceClass>& classes) {
  const Hall there = hall();
  return class_ids(there.scene, there.labels, classes).instances;
}

TEST(SceneLabels, APathNamesAllNodesAboveAndNumbersThoseWithoutName) {
  const FileLabels file = hall().labels.files[0];
  EXPECT_EQ(node_path(file, 0), "hall");
  EXPECT_EQ(node_path(file, 2), "hall/chair/cushion");
  EXPECT_EQ(node_path(file, 3), "hall/3");
}

TEST(SurfaceClasses, AreOfTheFirstThatMatchesNameOrPathOrMaterial) {
  EXPECT_THAT(instances_of({{"chair", {"chair"}, {}}}), ElementsAre(1, 0, 0, 0)) << "a name";
  EXPECT_THAT(instances_of({{"chair", {"*chair*"}, {}}}), ElementsAre(1, 1, 0, 0)) << "a path";
  EXPECT_THAT(instances_of({{"plain", {}, {"wood"}}, {"chair", {"*chair*"}, {}}}),
              ElementsAre(1, 2, 0, 1));
  EXPECT_THAT(instances_of({{"chair", {"*chair*"}, {}}, {"plain", {}, {"wood"}}}),
              ElementsAre(1, 1, 0, 2));
  EXPECT_THAT(instances_of({{"unnamed", {"3"}, {"cloth"}}}), ElementsAre(0, 1, 1, 1));
  EXPECT_THAT(instances_of({}), ElementsAre(0, 0, 0, 0));
}

TEST(SurfaceClasses, OfOneNameAreOneClass) {
  const std::vector<SurfaceClass> classes{
      {"a", {"cushion"}, {}}, {"b", {"3"}, {}}, {"a", {"chair"}, {}}};
  EXPECT_THAT(class_names(classes), ElementsAre("a", "b"));
  EXPECT_THAT(instances_of(classes), ElementsAre(1, 1, 2, 2));
}

TEST(SurfaceClasses, OfMaterialsAreThoseOfTheirNames) {
  const Hall there = hall();
  const ClassIds ids = class_ids(there.scene, there.labels, {{"x", {"*"}, {}}, {"y", {}, {"c*"}}});
  EXPECT_THAT(ids.materials, ElementsAre(0, 2));
  EXPECT_THAT(ids.instances, ElementsAre(1, 1, 1, 1));
}

TEST(SurfaceClasses, NameThePatternsThatMatchNothing) {
  const Hall there = hall();
  const ClassIds ids = class_ids(there.scene, there.labels,
                                 {{"x", {"*", "hall"}, {}}, {"y", {"cushion"}, {"glass"}}});
  EXPECT_THAT(ids.unmatched, ElementsAre("class x: no node that is shown matches \"hall\"",
                                         "class y: no material that is shown matches \"glass\""))
      << "the hall shows nothing itself, and that an earlier class has all is no reason for a note";
}

TEST(SurfaceClasses, AreRefusedWithoutNameOrPattern) {
  EXPECT_EQ(support::error_text([] {
              SurfaceClass{"", {"a"}, {}}.validate();
            }),
            "class: expected a name");
  EXPECT_EQ(support::error_text([] {
              SurfaceClass{"a", {}, {}}.validate();
            }),
            "class a: expected patterns of nodes or materials");
}

}  // namespace
}  // namespace synth
