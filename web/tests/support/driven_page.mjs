// A page in a browser, which a test drives.

export class DrivenPage {
  constructor(context, page, size) {
    this.context = context;
    this.page = page;
    this.size = size;
    this.errors = [];
  }

  wait(ms) {
    return new Promise((resolve) => setTimeout(resolve, ms));
  }

  /** Waits until the function is true in the page. */
  async until(what, test, argument, timeout = 15000) {
    try {
      await this.page.waitForFunction(test, argument, { timeout, polling: 50 });
    } catch (error) {
      throw new Error(`waited in vain for ${what}: ${String(error).split('\n')[0]}`);
    }
  }
}
