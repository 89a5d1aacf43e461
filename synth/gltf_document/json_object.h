#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace synth {

/// An object of a glTF document. Its members are read with their types checked; a member that is
/// absent gives an empty value. All errors are vo::Errors that begin with the object's place, like
/// "room.gltf: accessors[3]". The document must outlive it.
class JsonObject {
 public:
  /// Wraps the document's root; `file` names it in errors. Throws if it is no object.
  JsonObject(const nlohmann::json& document, std::string file);

  std::string place() const { return element_.empty() ? file_ : file_ + ": " + element_; }
  bool has(const std::string& key) const { return value_->contains(key); }
  std::vector<std::string> keys() const;

  std::optional<std::size_t> whole_number(const std::string& key) const;
  std::size_t required_whole_number(const std::string& key) const;
  std::optional<double> number(const std::string& key) const;
  std::optional<bool> flag(const std::string& key) const;
  std::optional<std::string> text(const std::string& key) const;
  std::string required_text(const std::string& key) const;
  /// Reads an array of exactly `size` numbers; empty if the member is absent.
  std::vector<double> numbers(const std::string& key, std::size_t size) const;
  std::vector<double> all_numbers(const std::string& key) const;
  std::vector<std::string> texts(const std::string& key) const;

  /// Reads an array of arrays of exactly `columns` numbers each; empty if the member is absent.
  std::vector<std::vector<double>> number_rows(const std::string& key, std::size_t columns) const;

  /// Reads an index into an array of `size` elements; nothing if the member is absent.
  std::optional<std::size_t> index(const std::string& key, std::size_t size) const;
  std::size_t required_index(const std::string& key, std::size_t size) const;
  std::vector<std::size_t> indices(const std::string& key, std::size_t size) const;
  /// Reads an array of arrays of exactly `columns` indices each.
  std::vector<std::vector<std::size_t>> index_rows(const std::string& key, std::size_t columns,
                                                   std::size_t size) const;

  std::optional<JsonObject> object(const std::string& key) const;
  JsonObject required_object(const std::string& key) const;
  std::vector<JsonObject> objects(const std::string& key) const;
  /// Returns the object's glTF extension of this name, if it has one.
  std::optional<JsonObject> extension(const std::string& name) const;

 private:
  JsonObject(const nlohmann::json& value, std::string file, std::string element);

  const nlohmann::json* find(const std::string& key) const;
  const nlohmann::json* find_array(const std::string& key) const;
  double checked_number(const nlohmann::json& value, const std::string& key) const;
  std::size_t checked_index(const nlohmann::json& value, const std::string& key,
                            std::size_t size) const;
  template <typename Element, typename Read>
  std::vector<std::vector<Element>> rows(const std::string& key, std::size_t columns,
                                         const Read& read) const;
  std::string child(const std::string& key) const;
  [[noreturn]] void reject(const std::string& key, const nlohmann::json& value,
                           const std::string& expected) const;

  const nlohmann::json* value_;
  std::string file_;
  std::string element_;  ///< path inside the document, empty for the document itself
};

}  // namespace synth
