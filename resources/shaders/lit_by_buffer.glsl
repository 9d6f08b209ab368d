// The parts of the sky's and of the key light that reach a surface: from the four nearest texels of the light buffer.
#ifdef WITHOUT_SHADOWS
vec2 lightReached(vec3 point, vec3 n) { return vec2(1.0); }
vec2 lightOnGround() { return vec2(1.0); }
#else
uniform sampler2D lightBuffer;

vec2 lightReached(vec3 point, vec3 n) {
    float d = dot(eye.xyz - point, back.xyz);
    vec3 sight = eye.w > 0.5 ? normalize(eye.xyz - point) : back.xyz;
    float slope = depthSlope(d, n, sight);
    vec2 at = gl_FragCoord.xy / viewport.xy * vec2(textureSize(lightBuffer, 0)) - 0.5, part = at - floor(at);
    ivec2 first = ivec2(floor(at)), last = textureSize(lightBuffer, 0) - 1;
    vec2 sum = vec2(0.0);
    float weights = 0.0;
    for (int k = 0; k < 4; ++k) {
        ivec2 corner = ivec2(k & 1, k >> 1);
        vec4 texel = texelFetch(lightBuffer, clamp(first + corner, ivec2(0), last), 0);
        vec2 near = mix(1.0 - part, part, vec2(corner));
        float weight = near.x * near.y * likeness(texel, d, slope, n);
        sum += weight * texel.xy;
        weights += weight;
    }
    return sum / max(weights, 1e-8);
}

// The same for the ground: its texels face upwards, and what is not ground among them hardly counts.
vec2 lightOnGround() {
    vec2 at = gl_FragCoord.xy / viewport.xy * vec2(textureSize(lightBuffer, 0)) - 0.5, part = at - floor(at);
    ivec2 first = ivec2(floor(at)), last = textureSize(lightBuffer, 0) - 1;
    vec2 sum = vec2(0.0);
    float weights = 0.0;
    for (int k = 0; k < 4; ++k) {
        ivec2 corner = ivec2(k & 1, k >> 1);
        vec4 texel = texelFetch(lightBuffer, clamp(first + corner, ivec2(0), last), 0);
        vec2 near = mix(1.0 - part, part, vec2(corner));
        float weight = near.x * near.y * (texel.w == kGroundTexel ? 1.0 : 1e-4);
        sum += weight * texel.xy;
        weights += weight;
    }
    return sum / max(weights, 1e-8);
}
#endif
