// Puts the accumulated transparent surfaces over the image, which is seen through them shifted, as glass refracts it.
uniform sampler2D source;      // sum of colours times weights; a: the product of transparencies
uniform sampler2D weights;     // sums of weights, and of displacements in pixels times weights
uniform sampler2D baseColour;  // the image
out vec4 pixel;

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 sum = texelFetch(source, at, 0);
    vec3 weight = texelFetch(weights, at, 0).rgb;
    if (weight.r <= 0.0) discard;
    vec2 place = (gl_FragCoord.xy + weight.gb / weight.r) / vec2(textureSize(baseColour, 0));
    pixel = vec4(mix(sum.rgb / weight.r, texture(baseColour, place).rgb, sum.a), 1.0);
}
