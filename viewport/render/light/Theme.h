#pragma once

namespace rubble {

enum class Theme { Light, Dark };

}  // namespace rubble
