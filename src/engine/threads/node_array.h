#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace runout {

/// Reserves a quarter more room than asked for. The numbers of nodes, pairs and cells grow by a few from step
/// to step, as soil reaches more of the bed; with spare room most steps allocate nothing.
template <class T>
void make_room(std::vector<T>& array, std::size_t size) {
    if (array.capacity() < size) array.reserve(size + size / 4);
}

/// Gives an array `size` elements. Their values are undefined: all must be written before they are read.
template <class T>
void fit(std::vector<T>& array, std::size_t size) {
    make_room(array, size);
    array.resize(size);
}

/// Gives an array `size` elements. Those from `first` on get one value; the values of those before are
/// undefined and must be written before they are read.
template <class T>
void set_rest(std::vector<T>& array, std::size_t first, std::size_t size, const T& value) {
    fit(array, size);
    std::fill(array.begin() + static_cast<std::ptrdiff_t>(first), array.end(), value);
}

/// Gives an array `size` elements, all of one value.
template <class T>
void set_all(std::vector<T>& array, std::size_t size, const T& value) {
    make_room(array, size);
    array.assign(size, value);
}

}  // namespace runout
