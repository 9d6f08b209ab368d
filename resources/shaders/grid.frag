// A grid in metres that fades with distance.
uniform vec3 worldOrigin;  // of the scene, modulo the grid's step
in vec3 scenePoint;
out vec4 pixel;

// The coverage of a pixel by lines of one pixel's width at multiples of `step`.
float gridCover(vec2 p, float step) {
    vec2 q = p / step;
    vec2 perPixel = max(fwidth(q), vec2(1e-6));
    vec2 pixels = abs(fract(q - 0.5) - 0.5) / perPixel;
    vec2 cover = (1.0 - smoothstep(0.0, 1.1, pixels)) * (1.0 - smoothstep(0.25, 0.6, perPixel));
    return max(cover.x, cover.y);
}

void main() {
    vec2 p = scenePoint.xz + worldOrigin.xz;
    float distance = length(scenePoint.xz - ground.xz) / ground.w;
    float fade = 1.0 - smoothstep(0.25, 1.0, distance);
    float lines = max(gridCover(p, spacing.x) * spacing.y * 0.55, gridCover(p, 10.0 * spacing.x));
    pixel = vec4(grid.rgb, grid.a * lines * fade);
}
