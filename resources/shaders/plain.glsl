// A body has the same colour all over; heat.glsl takes the place of this where it has not.
vec3 surfaceColour(vec3 colour, uint row, vec3 point, vec3 normal) { return colour; }
