// Blends the accumulated transparent surfaces over the image.
uniform sampler2D source;   // sum of colours times weights; a: the product of transparencies
uniform sampler2D weights;  // sum of weights
out vec4 pixel;

void main() {
    vec4 sum = texelFetch(source, ivec2(gl_FragCoord.xy), 0);
    float weight = texelFetch(weights, ivec2(gl_FragCoord.xy), 0).r;
    if (weight <= 0.0) discard;
    pixel = vec4(sum.rgb / weight, 1.0 - sum.a);
}
