// SPDX-License-Identifier: Apache-2.0
#pragma once
// Faults whose exact picture is unknown, but whose pixels have known bounds.
#include <optional>
#include <string>

#include "compare/byte_picture.h"

namespace glint {

/// "to the right and down".
std::string direction_text(int dx, int dy);

/// Clamps every channel of `faulty` to the range of the reference in the
/// neighbourhood [x + left, x + right] x [y + up, y + down]. This is what other samples in the pixels
/// could give: at the border of two colors anything between them, elsewhere the same color.
/// Fills these rows of `out`.
void nearest_between(const BytePicture& reference, const BytePicture& faulty, int left, int right, int up,
                     int down, const Rows& rows, int threads, BytePicture& out);

/// Of the pixels that differ by more than k_edge_step, the fraction of those that are mixed in one of the
/// pictures: the channel that varies most around the pixel is between its extremes there. 1 or nearly 1 for
/// means of samples, small for edges that have moved. Nothing if there are no such pixels.
std::optional<double> mixed_share(const BytePicture& reference, const BytePicture& faulty, const Rows& rows,
                                  int threads);

/// Of the neighbours in a row that are a step apart (is_step) in one of the pictures, the fraction of those
/// of which one differs between the pictures by more than k_noise. Other samples change most edges; what
/// changes only the edges of shadows leaves those of shapes. Nothing if there are no such neighbours.
std::optional<double> changed_edges_share(const BytePicture& reference, const BytePicture& faulty,
                                          const Rows& rows, int threads);

/// The reference with those pixels of `faulty` that are specks: clearly darker, away from edges, and with
/// neighbours equal to the reference. Fills these rows of `out`.
void put_dark_specks(const BytePicture& reference, const BytePicture& faulty, const Rows& rows, int threads,
                     BytePicture& out);

}  // namespace glint
