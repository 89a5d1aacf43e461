#pragma once

#include <opencv2/core.hpp>

/// Textures that are shown once and whole: pictures, prints, the rug.
namespace scenes {

cv::Mat rug_texture();            ///< 2.2 x 1.6 m
cv::Mat painting_texture();       ///< a coast at dusk
cv::Mat map_texture();            ///< the world, invented; u closes on itself
cv::Mat shapes_poster_texture();  ///< circles, bars and print
cv::Mat ridges_poster_texture();  ///< mountains behind mountains
cv::Mat clock_texture();          ///< a dial at eight past ten
cv::Mat screen_texture();         ///< an editor full of text
cv::Mat view_texture();           ///< what the window shows; mirrors at its sides
cv::Mat label_texture();          ///< the print on parcels, packets and magazines, grey
cv::Mat book_spines_texture();    ///< kBookSpines spines side by side, grey

inline constexpr int kBookSpines = 16;

}  // namespace scenes
