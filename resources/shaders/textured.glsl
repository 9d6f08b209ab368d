// Selects the variant of a program that draws batches with an image, whose other sides have finishes.
#define TEXTURED
#define FINISHED
