#pragma once

#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <utility>

namespace vo {

/// A vector of at most N elements that live inside it: it allocates nothing (as C++26's
/// std::inplace_vector).
template <typename T, std::size_t N>
class InplaceVector {
 public:
  InplaceVector() = default;
  InplaceVector(const InplaceVector& other) { fill(other.begin(), other.end()); }
  InplaceVector(InplaceVector&& other) noexcept {
    fill(std::make_move_iterator(other.begin()), std::make_move_iterator(other.end()));
  }
  InplaceVector& operator=(const InplaceVector& other) {
    if (this != &other) {
      clear();
      fill(other.begin(), other.end());
    }
    return *this;
  }
  InplaceVector& operator=(InplaceVector&& other) noexcept {
    if (this != &other) {
      clear();
      fill(std::make_move_iterator(other.begin()), std::make_move_iterator(other.end()));
    }
    return *this;
  }
  ~InplaceVector() { clear(); }

  /// Appends an element; throws std::length_error where there are N already.
  template <typename... Arguments>
  T& emplace_back(Arguments&&... arguments) {
    if (size_ == N) {
      throw std::length_error("InplaceVector: full");
    }
    T* element = std::construct_at(data() + size_, std::forward<Arguments>(arguments)...);
    ++size_;
    return *element;
  }
  void push_back(T element) { emplace_back(std::move(element)); }
  void pop_back() { std::destroy_at(data() + --size_); }
  void clear() {
    std::destroy(begin(), end());
    size_ = 0;
  }

  T* data() { return reinterpret_cast<T*>(bytes_.data()); }
  const T* data() const { return reinterpret_cast<const T*>(bytes_.data()); }
  T* begin() { return data(); }
  T* end() { return data() + size_; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }
  T& operator[](std::size_t index) { return data()[index]; }
  const T& operator[](std::size_t index) const { return data()[index]; }
  T& front() { return data()[0]; }
  const T& front() const { return data()[0]; }
  T& back() { return data()[size_ - 1]; }
  const T& back() const { return data()[size_ - 1]; }
  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

 private:
  /// Fills the empty vector with at most N elements.
  template <typename Iterator>
  void fill(Iterator first, Iterator last) {
    size_ = static_cast<std::size_t>(std::uninitialized_copy(first, last, data()) - data());
  }

  std::size_t size_ = 0;
  alignas(T) std::array<std::byte, N * sizeof(T)> bytes_;
};

}  // namespace vo
