// The distance of a pixel from the nearest edge of its face, in pixels; `placeAcross` is 0 or 1 at edges.
float pixelsToEdge(vec2 placeAcross) {
    vec2 part = min(placeAcross, 1.0 - placeAcross);
    vec2 stepX = dFdx(placeAcross), stepY = dFdy(placeAcross);
    vec2 perPixel = sqrt(stepX * stepX + stepY * stepY);
    vec2 pixels = part / max(perPixel, vec2(1e-6));
    return min(pixels.x, pixels.y);
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
