// SPDX-License-Identifier: Apache-2.0
// ply_body: the values of a .ply's elements, one row of floats at a time.
//
// Idea    The caller says where in its own row each property goes (kSkip: nowhere); the reader
//         hides the format, the byte order, the types and the lists. Rows without lists have a
//         fixed size, so whole blocks are taken from the source and floats are copied unseen.
// Rule    check_fits() first: an element that cannot fit what is left of the file is refused
//         before anyone reserves memory for it.
#pragma once

#include <functional>
#include <vector>

#include "scenes/ply/ply_header.hpp"

namespace pipegs {

inline constexpr int kSkip = -1;

// InputError "truncated" if `element` needs more bytes than the source has left.
void check_fits(const PlySource& source, PlyFormat format, const PlyElement& element);

// Reads all rows; slots[p] is the place of property p in `row`. A list has no place, only kSkip.
void read_rows(PlySource& source, PlyFormat format, const PlyElement& element, const std::vector<int>& slots,
               std::vector<float>& row, const std::function<void(std::size_t)>& on_row);

// InputError unless nothing but blanks (ASCII) or nothing at all (binary) follows the last element.
void check_end(PlySource& source, const PlyHeader& header);

}  // namespace pipegs
