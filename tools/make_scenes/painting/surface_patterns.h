#pragma once

#include <opencv2/core.hpp>

/// Textures that repeat over a surface. The comments give the size in metres they are drawn for;
/// grey ones are tinted by their material.
namespace scenes {

cv::Mat floor_planks_texture();  ///< 2.4 x 1.6, planks along u
cv::Mat brick_texture();         ///< 2.5 x 0.75
cv::Mat plaster_texture();       ///< 1.6 x 1.6, grey
cv::Mat wallpaper_texture();     ///< 0.4 x 0.4
cv::Mat wood_texture();          ///< 0.8 x 0.4, grey, grain along u
cv::Mat fabric_texture();        ///< 0.2 x 0.2, grey
cv::Mat carpet_texture();        ///< 0.2 x 0.2, grey
cv::Mat marble_texture();        ///< 0.6 x 0.6, grey
cv::Mat tiles_texture();         ///< 0.3 x 0.3
cv::Mat cardboard_texture();     ///< 0.5 x 0.5, grey
cv::Mat leaf_texture();          ///< one leaf, its stalk along v

}  // namespace scenes
