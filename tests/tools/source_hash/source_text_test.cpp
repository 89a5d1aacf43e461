#include "tools/source_hash/source_text.h"

#include <gtest/gtest.h>

namespace {

using tools::without_comments;

TEST(SourceText, CommentsAreWhiteSpace) {
  EXPECT_EQ(without_comments("int a;  // one\nint/* two */b;"), "int a; int b;");
  EXPECT_EQ(without_comments("// first\nint a; /* last"), "int a;");
  EXPECT_EQ(without_comments("// goes on \\\nhere\nint a;"), "int a;");
  EXPECT_EQ(without_comments("a /* // */ / b"), "a / b");
}

TEST(SourceText, LiteralsAreKept) {
  for (const char* code :
       {R"("http://a /* b */")", R"("quote \" // ")", "'\"'", R"('\'')", "u8'/'", R"("\\")",
        "R\"(a // b\n  \" c)\"", "u8R\"x(a)\" // )x\"", "1'000'000 / 2", "0xab'cd"}) {
    EXPECT_EQ(without_comments(std::string(code) + " // comment"), code);
  }
}

TEST(SourceText, DirectivesKeepTheirLines) {
  EXPECT_EQ(without_comments("#pragma once // c\n\n\n#define A 1 /* b\n */ + 2\nint\na;"),
            "#pragma once\n#define A 1 + 2\nint a;");
  EXPECT_EQ(without_comments("#define A \\\n  1\nint a = A;"), "#define A 1\nint a = A;");
  EXPECT_EQ(without_comments("int a;\n  #if B\nint b;\n#endif"), "int a;\n#if B\nint b;\n#endif");
}

}  // namespace
