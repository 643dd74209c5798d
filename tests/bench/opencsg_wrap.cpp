/* SPDX-License-Identifier: MIT */
#include "opencsg_wrap.h"

#include <GL/glew.h>
#include <memory>
#include <opencsg.h>
#include <vector>

namespace
{

class Solid : public OpenCSG::Primitive
{
  public:
    Solid(unsigned list, bool subtracted)
        : OpenCSG::Primitive(subtracted ? OpenCSG::Subtraction : OpenCSG::Intersection, 1),
          list_(list)
    {
    }
    void render() override
    {
        glCallList(list_);
    }

  private:
    unsigned list_;
};

} // namespace

struct opencsg_product {
    std::vector<std::unique_ptr<Solid>> solids;
    std::vector<OpenCSG::Primitive *> primitives;
};

struct opencsg_product *opencsg_product_create(void)
{
    return glewInit() == GLEW_OK ? new (std::nothrow) opencsg_product : nullptr;
}

void opencsg_product_destroy(struct opencsg_product *product)
{
    delete product;
}

bool opencsg_product_add(struct opencsg_product *product, unsigned list, bool subtracted)
{
    try {
        product->solids.push_back(std::make_unique<Solid>(list, subtracted));
        product->primitives.push_back(product->solids.back().get());
        return true;
    } catch (...) {
        return false;
    }
}

void opencsg_product_render(const struct opencsg_product *product)
{
    OpenCSG::render(product->primitives);
}
