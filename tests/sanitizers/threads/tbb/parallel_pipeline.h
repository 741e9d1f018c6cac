#pragma once
#include "../pipeline_of_frames.h"
