// The parts of the sky's and of the key light that reach a transparent surface, which the light buffer does not hold.
#ifdef WITHOUT_SHADOWS
vec2 lightReached(vec3 point, vec3 n) { return vec2(1.0); }
#else
vec2 lightReached(vec3 point, vec3 n) { return vec2(1.0, keyReached(point)); }
#endif
