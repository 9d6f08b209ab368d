#include "core/asset/Project.h"
