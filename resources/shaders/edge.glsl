// The distance of a pixel from the nearest edge of its face, in pixels; `placeAcross` is 0 or 1 at edges.
float pixelsToEdge(vec2 placeAcross) {
    vec2 part = min(placeAcross, 1.0 - placeAcross);
    vec2 stepX = dFdx(placeAcross), stepY = dFdy(placeAcross);
    vec2 perPixel = sqrt(stepX * stepX + stepY * stepY);
    vec2 pixels = part / max(perPixel, vec2(1e-6));
    return min(pixels.x, pixels.y);
}
// The direction within the face, towards the nearest edge, of length 1; `along`: the change of a point of the surface
// from pixel to pixel, to the right (0) and up (1).
vec3 towardsEdge(vec2 placeAcross, mat2x3 along) {
    vec2 part = min(placeAcross, 1.0 - placeAcross);
    vec2 stepX = dFdx(placeAcross), stepY = dFdy(placeAcross);
    vec2 pixels = part / max(sqrt(stepX * stepX + stepY * stepY), vec2(1e-6));
    bool isFirst = pixels.x < pixels.y;
    float place = isFirst ? placeAcross.x : placeAcross.y;
    vec2 rise = isFirst ? vec2(stepX.x, stepY.x) : vec2(stepX.y, stepY.y);  // from pixel to pixel
    // The gradient in the plane of the surface, by the inverse of its metric.
    float e = dot(along[0], along[0]), f = dot(along[0], along[1]), g = dot(along[1], along[1]);
    vec3 gradient = (g * rise.x - f * rise.y) * along[0] + (e * rise.y - f * rise.x) * along[1];
    return normalize(gradient + vec3(0.0, 1e-12, 0.0)) * (place < 0.5 ? -1.0 : 1.0);
}
// The width of a face in pixels: edges fade on narrow faces.
float pixelsAcross(vec2 placeAcross) {
    vec2 stepX = dFdx(placeAcross), stepY = dFdy(placeAcross);
    vec2 perPixel = sqrt(stepX * stepX + stepY * stepY);
    return 1.0 / max(max(perPixel.x, perPixel.y), 1e-6);
}
// The part of a pixel that a line of a width on each side of an edge covers; thinner than a pixel it grows fainter.
float lineCover(float pixels, float width) {
    float drawn = max(width, 0.5);
    return (1.0 - smoothstep(drawn - 0.5, drawn + 0.5, pixels)) * width / drawn;
}
