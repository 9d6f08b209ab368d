// What is behind all bodies: the sky, and the ground with shadows and a grid in metres, which fades into the horizon.
in vec2 place;
out vec4 pixel;

const float kHaze = 1.6;  // radii of the grid to the horizon's haze

// The coverage of a pixel by lines of one pixel's width at multiples of `step`.
float gridCover(vec2 p, vec2 perMetre, float step) {
    vec2 perPixel = max(perMetre / step, vec2(1e-6));
    vec2 pixels = abs(fract(p / step - 0.5) - 0.5) / perPixel;
    vec2 cover = (1.0 - smoothstep(0.0, 1.1, pixels)) * (1.0 - smoothstep(0.25, 0.6, perPixel));
    return max(cover.x, cover.y);
}
float gridLines(vec2 p, float distance) {
    vec2 world = p + gridOrigin.xz, perPixel = fwidth(world);
    float fade = 1.0 - smoothstep(0.15, 1.0, distance);
    float lines = max(gridCover(world, perPixel, spacing.x) * spacing.y * 0.5,
                      gridCover(world, perPixel, 10.0 * spacing.x));
    return lines * fade * grid.a * spacing.w;
}

#ifdef CONCRETE
float noise(vec2 p) {
    vec2 cell = floor(p), part = smoothstep(0.0, 1.0, p - cell);
    ivec2 at = ivec2(cell);
    return mix(mix(randomAt(at), randomAt(at + ivec2(1, 0)), part.x),
               mix(randomAt(at + ivec2(0, 1)), randomAt(at + ivec2(1, 1)), part.x), part.y);
}
// Blotches of 1.6 m and 8 cm, the smaller ones where they are larger than a pixel.
float groundTexture(vec2 p, float viewDepth) {
    vec2 world = p + gridOrigin.yw;
    float fine = smoothstep(1.0, 4.0, 0.08 * pixelsPerMetre(viewDepth));
    return 1.0 + 0.10 * (noise(world / 1.6) - 0.5) + 0.07 * fine * (noise(world / 0.08) - 0.5);
}
#else
float groundTexture(vec2 p, float viewDepth) { return 1.0; }
#endif

vec3 groundLit(vec2 p, float viewDepth) {
    vec2 reached = lightOnGround();
    return soil.rgb * groundTexture(p, viewDepth) * mix(vec3(reached.x), vec3(reached.y), groundKey.rgb);
}

void main() {
    Sight sight = sightAt(place);
    float d;
    bool isGround = meetsGround(sight, d);
    vec3 point = sight.from + d * sight.along;
    float distance = length(point.xz - ground.xz) / ground.w;
    float lines = gridLines(point.xz, distance);
    float clear = isGround ? exp(-distance * distance / (kHaze * kHaze)) : 0.0;  // of haze
    vec3 lit = groundLit(point.xz, d);
    vec3 plain = mix(backgroundBottom.rgb, backgroundTop.rgb, smoothstep(0.0, 1.0, place.y));
    vec3 colour = zenith.w < 0.5 ? mix(plain, displayed(lit), clear)
                                 : displayed(mix(skyRadiance(sight.along), lit, clear));
    colour = mix(colour, grid.rgb, lines * clear);
    pixel = vec4(colour + (gradientNoise(gl_FragCoord.xy) - 0.5) / 255.0, 1.0);  // against banding
}
