// The sky behind a scene.

// As backgroundRadiance() in viewport/render/light/Sky.cpp.
vec3 skyRadiance(vec3 along) {
    vec3 direction = normalize(along);
    float low = 1.0 - max(direction.y, 0.0);
    float near = exp2(horizon.w * (dot(direction, keyDirection.xyz) - 1.0));
    return mix(zenith.rgb, horizon.rgb, low * low * low) + sunGlow.rgb * near;
}
