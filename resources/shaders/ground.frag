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

vec3 groundLit() {
    vec3 key = keyLight.rgb * max(keyDirection.y, 0.0);
    vec2 reached = lightOnGround();
    vec3 light = key * reached.y + skyLight.rgb * reached.x + bounceLight.rgb * (0.35 + 0.65 * reached.x);
    return linearOf(soil.rgb) * light / (key + skyLight.rgb + bounceLight.rgb);
}

vec3 skyColour(vec3 along) {
    if (zenith.w < 0.5) return mix(backgroundBottom.rgb, backgroundTop.rgb, smoothstep(0.0, 1.0, place.y));
    float height = max(normalize(along).y, 0.0), low = 1.0 - height;
    return mix(horizon.rgb, zenith.rgb, 1.0 - low * low * low);
}

void main() {
    Sight sight = sightAt(place);
    vec3 colour = skyColour(sight.along);
    float d;
    bool isGround = meetsGround(sight, d);
    vec3 point = sight.from + d * sight.along;
    float distance = length(point.xz - ground.xz) / ground.w;
    float lines = gridLines(point.xz, distance);
    if (isGround) {
        vec3 lit = mix(srgbOf(groundLit()), grid.rgb, lines);
        colour = mix(colour, lit, exp(-distance * distance / (kHaze * kHaze)));
    }
    pixel = vec4(colour + (gradientNoise(gl_FragCoord.xy) - 0.5) / 255.0, 1.0);  // against banding
}
