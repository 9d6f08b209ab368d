// A grid in metres that fades with distance, and the shadows that fall on the ground.
uniform vec3 worldOrigin;  // of the scene, less whole steps of the grid
in vec3 scenePoint;
out vec4 pixel;

// How much of a pixel is covered by lines of one pixel at multiples of `step`.
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
    float opacity = grid.a * lines * fade;

    // Lines over the darkened ground.
    float key = keyDirection.w * max(keyDirection.y, 0.0);
    float sky = dot(skyLight.rgb, vec3(1.0 / 3.0));
    float skyShare = skyDirection.w == 0.0 ? 0.0 : 2.0 * skyDirection.y * (1.0 - skyReached(scenePoint));
    float missing = (key * (1.0 - keyReached(scenePoint)) + sky * skyShare) / (key + sky);
    float dark = spacing.z * min(missing, 1.0) * fade;
    float alpha = dark + opacity - dark * opacity;
    pixel = vec4(alpha > 0.0 ? grid.rgb * opacity / alpha : vec3(0.0), alpha);
}
