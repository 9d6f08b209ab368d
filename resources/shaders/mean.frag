// Copies a texture times a weight: adds a sample to the sum, or divides the sum.
uniform sampler2D source;
uniform float weight;
in vec2 place;
out vec4 pixel;

void main() { pixel = vec4(texture(source, place).rgb * weight, 1.0); }
