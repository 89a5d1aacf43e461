#include "vo/text_files/text_lines.h"

#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace {

using support::error_text;
using support::TempFolder;
using testing::ElementsAre;
using testing::HasSubstr;

TEST(TextFile, VisitsTheLinesThatHoldSomething) {
  const TempFolder folder;
  folder.write("list", "# head\r\n1 a,b\r\n\n  \t\n2\tc # comment\n#\n3");
  std::vector<std::string> seen;
  vo::TextFile(folder.path() / "list").for_each_line([&](const vo::TextLine& line) {
    std::string text = std::to_string(line.number) + ":";
    for (const std::string_view field : line.fields) {
      text += " " + std::string(field);
    }
    seen.push_back(text);
  });
  EXPECT_THAT(seen, ElementsAre("2: 1 a b", "5: 2 c", "7: 3"));
}

TEST(TextFile, NamesTheLineOfAValueThatIsNoNumber) {
  const TempFolder folder;
  folder.write("list", "1\n\ntwo\n");
  double sum = 0;
  EXPECT_THAT(error_text([&] {
                vo::TextFile(folder.path() / "list").for_each_line([&](const vo::TextLine& line) {
                  sum += vo::parse_number(line, 0);
                });
              }),
              HasSubstr("list:3: expected a number, got 'two' as value 1"));
  EXPECT_EQ(sum, 1);
}

}  // namespace
