// Adds a sample to the sum, or shows the mean of the sum.
uniform sampler2D source;
uniform float share;
in vec2 place;
out vec4 pixel;

void main() { pixel = vec4(texture(source, place).rgb * share, 1.0); }
