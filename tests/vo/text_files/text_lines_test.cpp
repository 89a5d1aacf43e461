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

TEST(TextFile, VisitsAllLinesWhereTheyAreAskedFor) {
  const TempFolder folder;
  folder.write("list", "# a,b\r\n\n1 2 # c");
  std::vector<std::string> seen;
  vo::TextFile(folder.path() / "list").for_each_whole_line([&](const vo::TextLine& line) {
    seen.push_back(std::to_string(line.number) + ":" + std::to_string(line.fields.size()) + ":" +
                   std::string(line.text));
  });
  EXPECT_THAT(seen, ElementsAre("1:3:# a,b\r", "2:0:", "3:4:1 2 # c"));
}

TEST(TextFile, KnowsItsFirstLineThatHoldsSomething) {
  const TempFolder folder;
  const vo::TextFile file(folder.write("list", "# head\n\n1 2 # c\n3\n"));
  EXPECT_EQ(file.first_line().number, 3U);
  EXPECT_THAT(file.first_line().fields, ElementsAre("1", "2"));
  const vo::TextFile empty(folder.write("empty", "# head\n"));
  EXPECT_TRUE(empty.first_line().fields.empty());
}

TEST(TextFile, SkipsAByteOrderMark) {
  const TempFolder folder;
  const vo::TextFile file(folder.write("list",
                                       "\xEF\xBB\xBF"
                                       "1 2\n\xEF\xBB\xBF"
                                       "3\n"));
  EXPECT_THAT(file.first_line().fields, ElementsAre("1", "2"));
  std::vector<std::string> seen;
  file.for_each_line([&](const vo::TextLine& line) { seen.emplace_back(line.text); });
  EXPECT_THAT(seen, ElementsAre("1 2",
                                "\xEF\xBB\xBF"
                                "3"))
      << "the begin alone has one";
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
