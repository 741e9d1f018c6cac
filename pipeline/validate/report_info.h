// What a checked document holds, counted. Knows nothing of faults.
#pragma once

#include "pipeline/validate/link.h"
#include "pipeline/validate/validate.h"

namespace barrido::scene::validation {

ValidationInfo info_of(const Link& link);

}  // namespace barrido::scene::validation
