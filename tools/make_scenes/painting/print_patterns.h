#pragma once

#include <opencv2/core.hpp>

/// Textures of the scenes beside the room: test patterns, floors, paper.
namespace scenes {

cv::Mat mosaic_texture();          ///< 6 x 3 m, cells of many sizes and colours, sharp
cv::Mat mosaic_box_texture();      ///< 1 x 1 m, mosaic with other colours
cv::Mat linoleum_texture();        ///< 1.2 x 1.2 m, four tiles
cv::Mat ceiling_panels_texture();  ///< 0.6 x 0.6 m, one panel, grey
cv::Mat exit_sign_texture();       ///< aspect ratio 2 : 1
cv::Mat page_texture();            ///< A4, print with a diagram
cv::Mat handwriting_texture();     ///< A4, lines by hand on squared paper
cv::Mat cork_texture();            ///< 0.4 x 0.4 m
cv::Mat ruler_texture();           ///< aspect ratio 32 : 4, millimetre marks
cv::Mat checker_texture();         ///< 8 x 8 squares in a frame
cv::Mat crate_texture();           ///< one side of a wooden crate
cv::Mat ball_texture();            ///< a ball; u around, v from pole to pole

}  // namespace scenes
