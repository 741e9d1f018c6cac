// Pictures of different kinds made comparable. Must not know: files, thresholds.
#pragma once

#include "pipeline/pictures/stored_picture.h"

namespace barrido::compare {

/// Where only one picture is linear, the other is decoded from sRGB; where only one has colours multiplied by
/// alpha, those of the other are multiplied. Pictures of the same kind stay as they are.
void put_on_same_footing(scene::StoredPicture& a, scene::StoredPicture& b);

}  // namespace barrido::compare
