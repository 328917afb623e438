#pragma once

#include "ar3d/algorithms/catalog.h"
