in vec2 place;
out vec4 pixel;

// Less than a step of eight bits, so that the gradient has no bands.
float noise(vec2 p) { return fract(52.9829189 * fract(dot(p, vec2(0.06711056, 0.00583715)))) - 0.5; }

void main() {
    vec3 colour = mix(backgroundBottom.rgb, backgroundTop.rgb, smoothstep(0.0, 1.0, place.y));
    pixel = vec4(colour + noise(gl_FragCoord.xy) / 255.0, 1.0);
}
