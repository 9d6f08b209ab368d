#pragma once

namespace rubble {

enum class Theme { Light, Dark };

/// Where a scene stands: what lights it, and what is behind it. The studio's backdrop is that of the theme.
enum class SkyPreset { Studio, Overcast, Morning, Evening, Night };

}  // namespace rubble
