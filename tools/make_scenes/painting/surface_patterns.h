#pragma once

#include <opencv2/core.hpp>

/// Textures that repeat over a surface, each with its size in metres; grey ones are tinted by their
/// material.
namespace scenes {

cv::Mat floor_planks_texture();  ///< 2.4 x 1.6 m, planks along u
cv::Mat brick_texture();         ///< 2.5 x 0.75 m
cv::Mat plaster_texture();       ///< 1.6 x 1.6 m, grey
cv::Mat wallpaper_texture();     ///< 0.4 x 0.4 m
cv::Mat wood_texture();          ///< 0.8 x 0.4 m, grey, grain along u
cv::Mat fabric_texture();        ///< 0.2 x 0.2 m, grey
cv::Mat carpet_texture();        ///< 0.2 x 0.2 m, grey
cv::Mat marble_texture();        ///< 0.6 x 0.6 m, grey
cv::Mat tiles_texture();         ///< 0.3 x 0.3 m
cv::Mat cardboard_texture();     ///< 0.5 x 0.5 m, grey
cv::Mat leaf_texture();          ///< one leaf, its stalk along v
cv::Mat tartan_texture();        ///< 0.36 x 0.36 m, one sett of a shirt's tartan
cv::Mat trousers_texture();      ///< 0.4 x 0.4 m, a coarser check

}  // namespace scenes
