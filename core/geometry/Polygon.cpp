#include "core/geometry/Polygon.h"
