// Selects the variant of a program that draws batches with an image.
#define TEXTURED
