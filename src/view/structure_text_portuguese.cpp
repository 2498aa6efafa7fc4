// The same in Portuguese.

#include "view/structure_text.h"

namespace raywalk {

std::string_view portuguese(StructureText id) {
  switch (id) {
    case StructureText::ray_primary:
      return "raio primário";
    case StructureText::ray_shadow:
      return "raio de sombra";
    case StructureText::ray_reflect:
      return "raio refletido";
    case StructureText::ray_refract:
      return "raio refratado";
    case StructureText::bvh:
      return "BVH";
    case StructureText::grid:
      return "Grade";
    case StructureText::octree:
      return "Octree";
    case StructureText::kdtree:
      return "kd-tree";
    case StructureText::none:
      return "Nenhuma";
    case StructureText::search:
      return "Busca";
    case StructureText::build:
      return "Construção";
    case StructureText::search_hint:
      return "Siga este raio pela estrutura";
    case StructureText::build_hint:
      return "Veja como a estrutura foi construída";
    case StructureText::kind_hint:
      return "Busque nesta estrutura";
    case StructureText::slider_hint:
      return "Até onde a busca ou a construção chegou";
    case StructureText::title_search:
      return "Busca do {0}";
    case StructureText::title_build:
      return "Como se constrói: {0}";
    case StructureText::counter:
      return "{0} / {1}";
    case StructureText::no_ray:
      return "Avance até que um raio se forme. A busca dele aparece aqui.";
    case StructureText::stub:
      return "Aqui não se formou raio, então nada se busca.";
    case StructureText::lost:
      return "Este raio não pode ser formado de novo; a busca não é mostrada.";
    case StructureText::too_large:
      return "{0} formas são demais para mostrar aqui: no máximo {1}.";
    case StructureText::not_begun:
      return "A busca não começou. Avance passo a passo.";
    case StructureText::shapes_none:
      return "nada";
    case StructureText::shapes_one:
      return "1 forma";
    case StructureText::shapes_many:
      return "{0} formas";
    case StructureText::entered_inner:
      return "Nó aberto: há {0} caixas nele.";
    case StructureText::entered_leaf:
      return "Folha aberta: ela lista {0}.";
    case StructureText::entered_cell:
      return "Célula aberta: ela lista {0}.";
    case StructureText::opened:
      return "Folha aberta: ela lista {0}. A caixa dela foi testada junto com as vizinhas.";
    case StructureText::skip_missed:
      return "Pulada: o raio não toca esta caixa.";
    case StructureText::skip_behind:
      return "Pulada: esta caixa fica atrás da origem do raio.";
    case StructureText::skip_beyond:
      return "Pulada: o raio chegaria lá em t = {0}, mas já atingiu algo em t = {1}.";
    case StructureText::skip_light:
      return "Pulada: esta caixa fica atrás da luz.";
    case StructureText::skip_off_plan:
      return "Pulada: esta caixa não chega ao plano, do qual o raio nunca sai.";
    case StructureText::test_missed:
      return "{0}: testada, o raio não a atinge.";
    case StructureText::test_nearest:
      return "{0}: testada, atingida em t = {1}, a mais próxima até agora.";
    case StructureText::test_farther:
      return "{0}: testada, atingida em t = {1}, atrás da mais próxima.";
    case StructureText::test_blocks:
      return "{0}: testada, está diante da luz.";
    case StructureText::test_filters:
      return "{0}: testada, a luz passa por ela, enfraquecida.";
    case StructureText::test_outside:
      return "Isso fica além desta célula: algo mais próximo ainda pode vir.";
    case StructureText::test_again:
      return "Já foi testada: ela também alcança esta caixa.";
    case StructureText::test_unbounded:
      return "Nenhuma caixa a contém, então todo raio a testa.";
    case StructureText::passed:
      return "{0} já foi testada em outra célula: não de novo.";
    case StructureText::end_all:
      return "Nada resta: a busca terminou.";
    case StructureText::end_blocked:
      return "Um obstáculo basta: a busca terminou.";
    case StructureText::end_beyond:
      return "A próxima célula começa atrás do ponto atingido: a busca terminou.";
    case StructureText::end_light:
      return "A próxima célula começa atrás da luz: a busca terminou.";
    case StructureText::end_left:
      return "O raio sai da grade: a busca terminou.";
    case StructureText::found:
      return "Encontrado: {0} em t = {1}.";
    case StructureText::found_nothing:
      return "Nada é atingido.";
    case StructureText::so_far:
      return "Até aqui: nós {0}, testes {1}";
    case StructureText::summary:
      return "{0}: {1} de {2} testes, {3} poupados";
    case StructureText::summary_more:
      return "{0}: {1} testes em vez de {2}, {3} a mais";
    case StructureText::summary_none:
      return "Sem estrutura: {0} testes";
    case StructureText::label_missed:
      return "não toca";
    case StructureText::label_behind:
      return "atrás";
    case StructureText::label_beyond:
      return "longe demais";
    case StructureText::label_off_plan:
      return "fora do plano";
    case StructureText::label_light:
      return "atrás da luz";
    case StructureText::column_nodes:
      return "Nós";
    case StructureText::column_tests:
      return "Testes";
    case StructureText::column_saved:
      return "Poupados";
    case StructureText::column_listed:
      return "Listadas";
    case StructureText::column_depth:
      return "Prof.";
    case StructureText::build_begins:
      return "Nada foi construído: há uma caixa em torno de {0}. Avance passo a passo.";
    case StructureText::build_none:
      return "Nada se constrói: todo raio testa toda forma.";
    case StructureText::build_empty:
      return "Nenhuma forma desta cena tem caixa; nada se pode construir.";
    case StructureText::split:
      return "{0}: corte em {1} = {2}, {3} de um lado, {4} do outro.";
    case StructureText::split_cost:
      return "Espera-se que um raio que chega aqui pague {0} testes com o corte, {1} sem ele.";
    case StructureText::halved:
      return "{0}: nenhum plano as separa; a lista é dividida ao meio.";
    case StructureText::eight:
      return "{0}: o cubo é cortado em oito, dos quais {1} contêm algo.";
    case StructureText::leaf_single:
      return "Folha: {0}.";
    case StructureText::leaf_few:
      return "Folha de {0}: bastante poucas.";
    case StructureText::leaf_dearer:
      return "Folha de {0}: o melhor corte custaria {1} testes, a folha custa {2}.";
    case StructureText::leaf_no_gain:
      return "Folha de {0}: um corte copiaria a maioria para quase todas as partes.";
    case StructureText::leaf_deep:
      return "Folha de {0}: a árvore já é tão funda quanto pode.";
    case StructureText::leaf_same:
      return "Folha de {0}: nenhum plano as separa.";
    case StructureText::joined:
      return "{0} caixas formam um nó: o raio é comparado com todas de uma vez.";
    case StructureText::cells:
      return "O espaço de {0} é cortado em {1} x {2} x {3} células, cerca de quatro por forma.";
    case StructureText::listed:
      return "{0} é listada em {1} células.";
    case StructureText::listed_once:
      return "{0} é listada em 1 célula.";
    case StructureText::note_unbounded:
      return "Formas sem fim, fora da estrutura: {0}.";
    case StructureText::note_above:
      return "A cena sai do plano: as caixas são desenhadas vistas de cima.";
    case StructureText::note_many:
      return "Só as {0} caixas de cima são desenhadas.";
    case StructureText::note_cut_short:
      return "Só os primeiros {0} passos são guardados.";
  }
  return {};
}

}  // namespace raywalk
