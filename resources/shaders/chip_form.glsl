// Chips: small solids of six triangles, two pyramids with a common base. Shapes as in ChipShape.
layout(location = 0) in vec4 centre;          // w: radius, m
layout(location = 1) in vec4 previousOffset;  // position and angle one step earlier minus those now
layout(location = 2) in vec4 rotation;        // axis and angle
layout(location = 3) in vec4 colour;          // sRGB; w: shape, plus the seed of the form in [0, 1)

vec3 chipCentre() { return centre.xyz + (1.0 - edges.w) * previousOffset.xyz; }
