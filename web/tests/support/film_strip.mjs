// Moments of the page side by side, each with a caption, as one picture.
import { writeFileSync } from 'node:fs';

/** In a page: the pictures side by side, as a PNG. */
async function joined([pictures, tile]) {
  const canvas = document.createElement('canvas');
  canvas.width = pictures.length * (tile.width + tile.gap) - tile.gap;
  canvas.height = tile.height;
  const pen = canvas.getContext('2d');
  pen.imageSmoothingQuality = 'high';
  for (const [i, { data, text }] of pictures.entries()) {
    const picture = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
    const x = i * (tile.width + tile.gap);
    pen.drawImage(picture, x, 0, tile.width, tile.height - tile.foot);
    pen.font = '600 13px Inter, sans-serif';
    const y = tile.foot > 0 ? tile.height - tile.foot / 2 : tile.height - 19;
    pen.fillStyle = tile.foot > 0 ? '#fff' : 'rgb(255 255 255 / 88%)';
    pen.beginPath();
    if (tile.foot > 0) pen.rect(x, tile.height - tile.foot, tile.width, tile.foot);
    else pen.roundRect(x + 8, y - 11, pen.measureText(text).width + 16, 22, 11);
    pen.fill();
    pen.fillStyle = '#171B20';
    pen.fillText(text, x + 16, y + 5);
  }
  return canvas.toDataURL('image/png').split(',')[1];
}

/** `pictures`: PNG in base64 and caption; `tile`: size of each [px], the gap, and the height of a foot that holds the caption;
 * without a foot it stands on the picture. */
export async function writeStrip(context, path, pictures, tile) {
  const blank = await context.newPage();
  const data = await blank.evaluate(joined, [pictures, { foot: 0, ...tile }]);
  writeFileSync(path, Buffer.from(data, 'base64'));
  await blank.close();
}
