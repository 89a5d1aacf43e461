#pragma once

#include "vo/mapping/hypotheses.h"

namespace vo {

/// Smooths inverse depths along the edges: a line is fitted through those neighbours within five
/// pixels along the chain that agree, weighted by inverse variance. The unsmoothed inverse depths
/// and variances do not change, so nothing is counted twice.
void smooth_along_chains(Hypotheses& hypotheses);

/// Forgets confident hypotheses that disagree with neighbours that agree; returns their number.
std::size_t forget_lonely(float guess, Hypotheses& hypotheses);

/// Gives edge pixels of unknown depth the mean of the known, confident pixels within two pixels if
/// there are at least two and all agree within 10 %; returns their number.
std::size_t fill_from_neighbours(Hypotheses& hypotheses);

}  // namespace vo
