#include "tools/processes/shell_words.h"

#include <algorithm>
#include <array>
#include <utility>

#include "vo/core/error.h"

namespace tools {
namespace {

constexpr std::string_view kOperators = "|&;<>()$`\n";

class WordSplitter {
 public:
  explicit WordSplitter(std::string_view text) : rest_(text) {}

  std::vector<std::string> split() {
    while (!rest_.empty()) {
      const char c = take();
      switch (c) {
        case ' ':
        case '\t':
          end_word();
          break;
        case '\'':
          take_single_quoted();
          break;
        case '"':
          take_double_quoted();
          break;
        case '\\':
          take_escaped();
          break;
        default:
          take_plain(c);
      }
    }
    end_word();
    return std::move(words_);
  }

 private:
  char take() {
    const char c = rest_.front();
    rest_.remove_prefix(1);
    return c;
  }

  void add(char c) {
    word_ += c;
    has_word_ = true;
  }

  void end_word() {
    if (has_word_) {
      words_.push_back(std::move(word_));
    }
    word_.clear();
    has_word_ = false;
  }

  void take_plain(char c) {
    const bool begins_comment_or_home = !has_word_ && (c == '#' || c == '~');
    vo::require(kOperators.find(c) == std::string_view::npos && !begins_comment_or_home,
                "has an unquoted ", c == '\n' ? std::string("end of line") : std::string(1, c),
                ", which only a shell understands");
    add(c);
  }

  void take_escaped() {
    vo::require(!rest_.empty(), "ends with a backslash");
    if (const char c = take(); c != '\n') {
      add(c);
    }
  }

  void take_single_quoted() {
    const std::size_t end = rest_.find('\'');
    vo::require(end != std::string_view::npos, "has a ' without its other");
    word_ += rest_.substr(0, end);
    has_word_ = true;
    rest_.remove_prefix(end + 1);
  }

  void take_double_quoted() {
    constexpr std::string_view kEscapable = "$`\"\\\n";
    has_word_ = true;
    for (char c = 0; !rest_.empty();) {
      c = take();
      if (c == '"') {
        return;
      }
      if (c == '\\' && !rest_.empty() && kEscapable.find(rest_.front()) != std::string_view::npos) {
        take_escaped();
      } else {
        add(c);
      }
    }
    vo::fail("has a \" without its other");
  }

  std::string_view rest_;
  std::string word_;
  bool has_word_ = false;  ///< also true for an empty word in quotes
  std::vector<std::string> words_;
};

bool is_shell(std::string_view word) {
  constexpr std::array<std::string_view, 8> kShells{"sh",  "bash", "dash", "zsh",
                                                    "ksh", "mksh", "ash",  "fish"};
  const std::string_view name = word.substr(word.rfind('/') + 1);
  return std::find(kShells.begin(), kShells.end(), name) != kShells.end();
}

/// Returns whether the word is options of a shell with -c among them, such as `-ec`.
bool asks_for_script(std::string_view word) {
  return word.size() > 1 && word[0] == '-' && word[1] != '-' &&
         word.find('c') != std::string_view::npos;
}

bool is_option(std::string_view word) {
  return word.starts_with('-') || word.starts_with('+');
}

}  // namespace

std::vector<std::string> split_words(std::string_view text) {
  return WordSplitter(text).split();
}

std::string shell_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}

std::vector<std::size_t> script_indices(const std::vector<std::string>& words) {
  std::vector<std::size_t> indices;
  for (std::size_t shell = 0; shell < words.size(); ++shell) {
    bool has_script = false;
    std::size_t i = shell + 1;
    for (; is_shell(words[shell]) && i < words.size() && is_option(words[i]); ++i) {
      has_script = has_script || asks_for_script(words[i]);
    }
    if (has_script && i < words.size()) {
      indices.push_back(i);
    }
  }
  return indices;
}

}  // namespace tools
