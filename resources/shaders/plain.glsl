// One colour for the whole surface; the alternative is heat.glsl.
vec3 surfaceColour(vec3 colour, uint row, vec3 point, vec3 normal) { return colour; }
