#pragma once

#include <opencv2/core.hpp>

/// Textures that are shown once as a whole: pictures, prints, the rug.
namespace scenes {

cv::Mat rug_texture();            ///< 2.2 x 1.6 m
cv::Mat painting_texture();       ///< a coast at dusk
cv::Mat map_texture();            ///< a fictitious world; periodic in u
cv::Mat shapes_poster_texture();  ///< circles, bars and print
cv::Mat ridges_poster_texture();  ///< layered mountain ridges
cv::Mat clock_texture();          ///< a dial at eight past ten
cv::Mat screen_texture();         ///< an editor full of text
cv::Mat view_texture();           ///< the view from the window; tiles when mirrored
cv::Mat label_texture();          ///< the print on parcels, packets and magazines, grey
cv::Mat book_spines_texture();    ///< kBookSpines spines side by side, grey

inline constexpr int kBookSpines = 16;

}  // namespace scenes
